#!/usr/bin/env bash
# The main job from nothing: simulates a drive, records it as LIO-SAM would, filters the bag, and scores the
# result. Installs and builds what is missing.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/build.sh" segdf_simulate segdf_kitti_to_bag segdf_offline segdf_evaluate
bin="$root/build/devel/lib/segdf"
demo="$root/build/demo"
rm -rf "$demo"
mkdir -p "$demo"

echo "== simulating a drive through a street (HDL-64E, 100 scans)"
"$bin/segdf_simulate" --output "$demo/drive" --sensor hdl64 --scans 100 --seed 1
echo "== recording it as a bag"
"$bin/segdf_kitti_to_bag" --kitti "$demo/drive" --output "$demo/drive.bag"
echo "== filtering the bag"
"$bin/segdf_offline" --bag "$demo/drive.bag" --output "$demo/result" --threads "$(nproc)"
echo "== comparing with the truth"
"$bin/segdf_evaluate" --kitti "$demo/drive" --labels "$demo/result/labels" --json "$demo/result/score.json"

cat <<EOF

static map     $demo/result/static_map.pcd
picture        $demo/result/map.png
instances      $demo/result/instances.csv
EOF

#!/usr/bin/env bash
# Runs and scores the segments of SemanticKITTI that the field publishes figures for (docs/evaluation.md):
# score_semantickitti.sh DATASET OUTPUT [segdf_offline options ...]
# DATASET holds sequences/NN with velodyne/, labels/, calib.txt and poses.txt (SemanticKITTI's own poses, by SuMa).
set -euo pipefail

[ $# -ge 2 ] || { echo "usage: $0 DATASET OUTPUT [segdf_offline options ...]" >&2; exit 2; }
dataset=$1 output=$2
shift 2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin="$root/build/devel/lib/segdf"
[ -x "$bin/segdf_offline" ] || { echo "error: segdf is not built; run $root/scripts/build.sh" >&2; exit 1; }

# sequence, and first:last:step of its segment
segments=(00=4390:4530:2 01=150:250:1 02=860:950:2 05=2350:2670:2 07=630:820:2)
for segment in "${segments[@]}"; do
  drive="$dataset/sequences/${segment%%=*}"
  [ -d "$drive/velodyne" ] || { echo "error: no $drive/velodyne; is $dataset SemanticKITTI?" >&2; exit 1; }
done
for segment in "${segments[@]}"; do
  sequence=${segment%%=*} frames=${segment#*=}
  result="$output/$sequence"
  echo "== $sequence $frames"
  "$bin/segdf_offline" --kitti "$dataset/sequences/$sequence" --frames "$frames" --output "$result" "$@"
  "$bin/segdf_evaluate" --kitti "$dataset/sequences/$sequence" --frames "$frames" --labels "$result/labels" \
    --json "$result/score.json" --report "$result"
done

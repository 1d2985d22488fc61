#!/usr/bin/env bash
# Filters one real sequence on 1 and 2 threads, compares the labels, and scores them:
#   check_sequence.sh SEQUENCE SEGDF_OFFLINE SEGDF_EVALUATE WORK_DIR RATE MODE SA DA PARKED_SA [VARIATION]
# SA, DA and PARKED_SA are floors; VARIATION is one of vary_sequence.py. Exit 77 means skipped.
set -euo pipefail
sequence=$1 offline=$2 evaluate=$3 work=$4 rate=$5 mode=$6 variation=${10:-}

drive="${SEGDF_DATA:-}/$sequence"
if [ -z "${SEGDF_DATA:-}" ] || [ ! -d "$drive/velodyne" ]; then
  echo "skipped: SEGDF_DATA names no folder with $sequence"
  exit 77
fi

rm -rf "$work"
mkdir -p "$work"
if [ -n "$variation" ]; then
  python3 "$(dirname "$0")/vary_sequence.py" "$drive" "$work/drive" "$variation"
  drive="$work/drive"
fi
run() { "$offline" --kitti "$drive" --mode "$mode" --rate "$rate" --threads "$1" --output "$work/$1"; }
run 1
run 2 2>/dev/null
diff -r "$work/1/labels" "$work/2/labels" || { echo "labels differ between 1 and 2 threads"; exit 1; }
"$evaluate" --kitti "$drive" --labels "$work/1/labels" --json "$work/score.json"
python3 - "$work/score.json" "${@:7:3}" <<'EOF'
import json
import sys

score = json.load(open(sys.argv[1]))
floors = dict(zip(("SA", "DA", "parked_SA"), map(float, sys.argv[2:])))
low = {k: score[k] for k, floor in floors.items() if score[k] is not None and score[k] < floor}
sys.exit(f"below the floor: {low}" if low else 0)
EOF
rm -rf "$work"

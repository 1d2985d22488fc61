#!/usr/bin/env bash
# A drive that reaches the pass marks of its scene is passed, one that misses them is not, and told:
#   check_scene_marks.sh SCENE_TABLE WORK_DIR
set -euo pipefail
table=$1 work=$2
rm -rf "$work"
mkdir -p "$work"
score() {
  printf '{"SA": %s, "DA": %s, "parked_SA": 100, "instances": 4, "instances_removed": %s, "static_instances": 9,
    "static_instances_removed": %s}' "$@" >"$work/score.s03_oncoming.1.json"
}
expect_missed() {
  if "$table" "$work" s03_oncoming >"$work/table"; then
    echo "passed, without $1" && exit 1
  fi
  grep "below its mark: s03_oncoming, seed 1: $1" "$work/table"
}
score 99.95 97 4 0
"$table" "$work" s03_oncoming
score 99.85 97 4 0
expect_missed "SA 99.85 of 99.9"
score 99.95 95.5 4 0
expect_missed "DA 95.5 of 96"
score 99.95 97 3 0
expect_missed "movers 75 of 100"
score 99.95 97 4 1
expect_missed "1 standing removed"
"$table" "$work" s03_oncoming --no-marks
rm -rf "$work"

#!/usr/bin/env bash
# Launches a file for real and waits until the results are there:
# check_launched.sh DEVEL_DIR LAUNCH_DIR FILE ARGUMENT...   (OUT in an argument is a folder of its own)
set -euo pipefail
# shellcheck source=test/ros/devel_environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/devel_environment.sh"
out=$(mktemp -d)
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI="http://localhost:$port"
roslaunch -p "$port" "$file" "${@//OUT/$out}" >"$out/log" 2>&1 &
launched=$!
finish() {
  kill -INT "$launched" 2>/dev/null || true
  wait "$launched" 2>/dev/null || true
  rm -rf "$out"
}
trap finish EXIT
for _ in $(seq 600); do
  [ ! -s "$out/result/report.json" ] || break
  sleep 0.1
done
tr '\r' '\n' <"$out/log" | tail -40
ls "$out/result"
for name in static_map.pcd dynamic_points.pcd instances.csv evidence.csv config.yaml map.png report.json; do
  [ -s "$out/result/$name" ] || { echo "no $name"; exit 1; }
done

#!/usr/bin/env bash
# No memory is lost and no thread stays behind when the nodelet is unloaded:
# check_leaks.sh DEVEL_DIR PROGRAM_DIR PROGRAM
# Exit 77: valgrind is not installed.
set -euo pipefail
command -v valgrind >/dev/null || { echo "skipped: no valgrind"; exit 77; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=test/ros/devel_environment.sh
source "$here/devel_environment.sh"
work=$(mktemp -d)
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI="http://127.0.0.1:$port" ROS_IP=127.0.0.1 ROS_HOME="$work" ROS_LOG_DIR="$work"
rosmaster --core -p "$port" >"$work/master.log" 2>&1 &
master=$!
finish() {
  kill "$master" 2>/dev/null || true
  wait "$master" 2>/dev/null || true
  rm -rf "$work"
}
trap finish EXIT
# Valgrind runs one thread at a time: scheduled in turn, none of those that only wait starves the others.
timeout -k 5 240 valgrind --error-exitcode=3 --leak-check=full --show-leak-kinds=definite,indirect \
  --errors-for-leak-kinds=definite,indirect --keep-debuginfo=yes --fair-sched=try --num-callers=30 \
  "$file"

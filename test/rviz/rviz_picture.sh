#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Plays a simulated drive through segdf.launch, with rviz/segdf.rviz on a screen of its own, and takes a picture:
#   rviz_picture.sh DEVEL_DIR PICTURE.png [--docs]
# It fails unless the picture shows a map (check_picture.py). With --docs the drive is longer and the picture small
# enough for docs/images/rviz.png. Screen, ROS master and log folder are its own; all it starts, it stops.
# Exit 77: a program that is needed is not installed.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
devel=$(cd "$1" && pwd)
picture=$(realpath -m "$2")
drive=(--sensor vlp16 --scans 35 --seed 7) scans=35
docs=false
[ "${3:-}" != --docs ] || { docs=true; drive=(--sensor hdl32 --scans 50 --seed 1); scans=50; }

# ROS tools are written for the system's Python.
export PATH="/usr/bin:$PATH"
for program in Xvfb import rosbag roslaunch rosservice rostopic rviz; do
  command -v "$program" >/dev/null || { echo "skipped: no $program"; exit 77; }
done

work=$(mktemp -d)
pids=()
seen=

# The last that was started goes first, and a launch gets the time to stop its nodes; those that stay behind are
# its children, and are ended too.
stop_all() {
  local children pid
  for ((i = ${#pids[@]} - 1; i >= 0; --i)); do
    pid=${pids[i]}
    children=$(pgrep -P "$pid" || true)
    kill -INT "$pid" 2>/dev/null || true
    for _ in $(seq 300); do
      kill -0 "$pid" 2>/dev/null || break
      sleep 0.1
    done
    for pid in $pid $children; do kill -KILL "$pid" 2>/dev/null || true; done
  done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap stop_all EXIT
trap 'exit 1' INT TERM

fail() {
  echo "error: $1" >&2
  tail -n 20 "$work"/*.log >&2 || true
  exit 1
}

# wait_for SECONDS WHAT COMMAND...: until the command succeeds
wait_for() {
  local limit=$((SECONDS + $1)) what=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $limit ] || fail "waited in vain for $what"
    sleep 0.5
  done
}

# start NAME COMMAND...: in the background. A shell lets its background ignore Ctrl-C, which is how they are stopped.
start() {
  local log="$work/$1.log"
  shift
  python3 -c 'import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
os.execvp(sys.argv[1], sys.argv[1:])' "$@" >"$log" 2>&1 &
  pids+=($!)
}

take_picture() { import -window root "$work/picture.png"; }
shows_map() { take_picture && python3 "$here/check_picture.py" "$work/picture.png"; }
# Twice the same: nothing is on its way to the screen any more.
settled() {
  local before=$seen
  seen=$(shows_map) && [ "$seen" = "$before" ]
}
rviz_listens() { [[ $(rostopic info /segdf/dynamic_cloud) == *Subscribers:*segdf_rviz* ]]; }
played() { ! kill -0 "$player"; }
all_decided() { [[ $(rosservice call /segdf/flush) == *"$scans frames published"* ]]; }

"$devel/lib/segdf/segdf_simulate" "${drive[@]}" --bag "$work/drive.bag" >"$work/simulate.log" 2>&1 ||
  fail "the drive cannot be simulated"

start screen Xvfb -displayfd 1 -screen 0 1400x900x24 -nolisten tcp
wait_for 60 "the screen" grep -q '^[0-9]' "$work/screen.log"
DISPLAY=:$(grep -m1 '^[0-9]' "$work/screen.log")
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1
export HOME="$work" XDG_RUNTIME_DIR="$work" ROS_HOME="$work" ROS_LOG_DIR="$work/ros"

set +u  # the generated script is not written for it
# shellcheck disable=SC1091
source "$devel/setup.bash"
set -u
port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1
unset ROS_HOSTNAME

start launch roslaunch --port "$port" segdf segdf.launch use_sim_time:=true rviz:=true
wait_for 120 "rviz to listen" rviz_listens
shows_map >/dev/null && fail "the picture of an empty rviz passes for a map"
start player rosbag play --quiet --clock --wait-for-subscribers "$work/drive.bag" --topics \
  /lio_sam/mapping/cloud_registered_raw /lio_sam/mapping/odometry
player=${pids[-1]}
wait_for 180 "the end of the bag" played
wait_for 120 "the last scans" all_decided
wait_for 120 "a picture of the map that stays" settled
echo "$seen"

mkdir -p "$(dirname "$picture")"
if $docs; then
  convert "$work/picture.png" +dither -colors 96 -strip "PNG8:$picture"
else
  cp "$work/picture.png" "$picture"
fi

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Runs demo.launch, which plays a simulated drive and opens rviz, on a screen of its own, and takes a picture:
#   rviz_picture.sh DEVEL_DIR PICTURE.png [--docs]
# It fails unless the picture shows map, trails and boxes (check_picture.py). With --docs the sensor has more lasers and
# the picture is small enough for docs/images/rviz.png. Screen, ROS master and log folder are its own; all it starts,
# it stops.
# Exit 77: a program that is needed is not installed.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
devel=$(cd "$1" && pwd)
picture=$(realpath -m "$2")
sensor=vlp16 scans=35
docs=false
[ "${3:-}" != --docs ] || { docs=true; sensor=hdl32; }

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
  for log in "$work"/*.log; do tr '\r' '\n' <"$log" | grep -v 'Bag Time' | tail -n 20 >&2; done
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
shows_all() { take_picture && python3 "$here/check_picture.py" "$work/picture.png"; }
# Twice the same: nothing is on its way to the screen any more.
settled() {
  local before=$seen
  seen=$(shows_all) && [ "$seen" = "$before" ]
}
rviz_hears() { [[ $(rostopic info "/segdf/$1") == *Subscribers:*segdf_rviz* ]]; }
rviz_listens() { rviz_hears static_map && rviz_hears dynamic_cloud && rviz_hears markers; }
play() { rosservice call /segdf_player/pause_playback false; }
all_received() { rostopic echo -n 1 /diagnostics | grep -A 1 '"clouds received"' | grep "\"$scans\""; }
all_decided() { [[ $(rosservice call /segdf/flush) == *"$scans frames published"* ]]; }

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

# The player is held until rviz listens, which does not get the trails afterwards, and stays when it is done: one
# that ends drops what it has not sent.
start launch roslaunch --port "$port" segdf demo.launch "bag:=$work/drive.bag" rviz:=true \
  "simulate:=--sensor $sensor --scans $scans --seed 7" "player_args:=--pause --keep-alive"
wait_for 120 "rviz to listen" rviz_listens
shows_all >/dev/null && fail "the picture of an empty rviz passes"
wait_for 60 "the player" play
wait_for 120 "the clouds" all_received
wait_for 60 "the last scans" all_decided
wait_for 120 "a picture that shows all, and stays" settled
echo "$seen"

mkdir -p "$(dirname "$picture")"
if $docs; then
  convert "$work/picture.png" +dither -colors 96 -strip "PNG8:$picture"
else
  cp "$work/picture.png" "$picture"
fi

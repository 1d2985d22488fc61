# shellcheck shell=bash
# Sourced by the tests that start nodes: DEVEL_DIR FOLDER FILE ARGUMENT... become $file and the arguments, and ROS
# finds this build.
devel=$1
file=$2/$3
shift 3
set +u  # catkin's own scripts read variables that need not be set
# shellcheck disable=SC1091
source "$devel/setup.bash"
set -u
export PATH="/usr/bin:$PATH"

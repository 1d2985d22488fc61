#!/usr/bin/env bash
# A launch file can be read with these arguments, and every node of ours in it exists:
# check_launch.sh DEVEL_DIR LAUNCH_DIR FILE ARGUMENT...
set -euo pipefail
devel=$1
file=$2/$3
shift 3
set +u  # catkin's own scripts read variables that need not be set
# shellcheck disable=SC1091
source "$devel/setup.bash"
set -u
export PATH="/usr/bin:$PATH"
# Does not start anything, and does not need rviz.
roslaunch --nodes "$file" "$@"
while read -r node; do
  case $node in
    /segdf_rviz) continue ;;
  esac
  command=$(roslaunch --args "$node" "$file" "$@")
  echo "$node: $command"
  [[ $command != *'$('* ]] || { echo "a substitution is left over"; exit 1; }
done < <(roslaunch --nodes "$file" "$@")

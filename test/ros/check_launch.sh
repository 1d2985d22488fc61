#!/usr/bin/env bash
# A launch file can be read with these arguments, and every node of ours in it exists:
# check_launch.sh DEVEL_DIR LAUNCH_DIR FILE ARGUMENT...
set -euo pipefail
# shellcheck source=test/ros/devel_environment.sh
source "$(dirname "${BASH_SOURCE[0]}")/devel_environment.sh"
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

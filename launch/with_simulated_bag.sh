#!/usr/bin/env bash
# Makes a bag by the simulator unless it is there, then becomes the given command:
# with_simulated_bag.sh BAG 'OPTIONS OF segdf_simulate' COMMAND...
set -euo pipefail
bag=$1
read -ra options <<<"$2"
shift 2
if [ ! -e "$bag" ]; then
  simulate=$(catkin_find --first-only --libexec segdf segdf_simulate)
  [ -n "$simulate" ] || { echo "error: segdf_simulate is not built" >&2; exit 1; }
  echo "simulating a drive into $bag"
  "$simulate" --bag "$bag" "${options[@]}"
fi
exec "$@"

# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the workspace's setup.sh: the programs are found by name, without rosrun.
case ":$PATH:" in
  *":$CATKIN_ENV_HOOK_WORKSPACE/lib/segdf:"*) ;;
  *) export PATH="$CATKIN_ENV_HOOK_WORKSPACE/lib/segdf:$PATH" ;;
esac

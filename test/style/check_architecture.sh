#!/usr/bin/env bash
# Includes follow the house (docs/architecture.md): each room uses those before it in the flow, and ROS, PCL and
# other libraries stay in their rooms.
set -euo pipefail
cd "$1"
status=0

# check ROOM 'allowed segdf rooms' 'forbidden foreign headers (regex)'
check() {
  local room=$1 allowed=$2 forbidden=$3 files
  files=$(find "include/segdf/$room" "src/$room" -name '*.hpp' -o -name '*.cpp')
  local bad
  bad=$(grep -HnE '#include "segdf/' $files | grep -vE "#include \"segdf/(${allowed// /|})/" || true)
  bad+=$(grep -HnE "#include [<\"]($forbidden)" $files || true)
  [ -z "$bad" ] || { printf '%s may not include:\n%s\n' "$room" "$bad"; status=1; }
}

ros='ros/|rosbag/|nodelet/|pluginlib/|tf2|message_filters/|[a-z_]*_msgs/|std_srvs/|diagnostic_updater/|dynamic_reconfigure/|pcl_ros/|pcl_conversions/|segdf/[A-Z]'  # and our own messages
outside="$ros|pcl/|yaml-cpp/|nlohmann/|png|cairo|embree3/|CLI/"
check core 'core' "$outside"
check segmentation 'core segmentation' "$outside"
check classification 'core segmentation classification' "$outside"
check dynamics 'core segmentation classification dynamics' "$outside"
check mapping 'core mapping' "$outside"
check pipeline 'core segmentation classification dynamics pipeline' "$outside"
check evaluation 'core evaluation' "$outside"
check simulation 'core simulation' "$ros|pcl/|nlohmann/|png|cairo|CLI/"  # yaml-cpp: scenes are YAML
check io 'core segmentation mapping io' "$ros|embree3/|CLI/"
# It turns scores into files for people, so it needs both the scores and the writers; they need not know it.
check report 'core evaluation io report' "$ros|pcl/|yaml-cpp/|png|cairo|embree3/|CLI/"
check ros 'core segmentation dynamics mapping pipeline io ros' 'embree3/|CLI/'
check nodelets 'core segmentation mapping pipeline io ros nodelets' 'embree3/|CLI/'

# Two types of one name are one to the linker, which keeps the functions of either.
twice=$(find include -name '*.hpp' -exec grep -hoE '^(class|struct) [A-Za-z]+( final)? ?[:{]' {} + | awk '{ print $2 }' | sort | uniq -d)
[ -z "$twice" ] || { printf 'defined twice:\n%s\n' "$twice"; status=1; }
exit $status

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <rosbag/bag.h>

namespace segdf {

/// For a bag without odometry: arguments of segdf.launch that take the poses of the clouds from its
/// tf, "use_tf:=true map_frame:=odom"; "" if tf does not lead to the clouds. Clouds whose frame is
/// the root of tf are registered: sensor_frame names the only frame that moves in it.
/// @param cloud_topic of sensor_msgs/PointCloud2. Reads one cloud, and all of tf.
std::string tfArguments(const rosbag::Bag& bag, const std::string& cloud_topic);

}  // namespace segdf

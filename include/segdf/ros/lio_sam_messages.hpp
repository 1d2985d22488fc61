// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/core/scan.hpp"

/// A scan as the messages that LIO-SAM would have published for it. The inverse is toScan() in
/// ros/conversions.hpp. Stamps are the scan's own, which must be > 0: ROS takes time 0 for "not
/// set".
namespace segdf {

/// x y z intensity in the frame `odom`; ring and time are lost, as in LIO-SAM.
sensor_msgs::PointCloud2 toRegisteredCloud(const Scan& scan);

/// x y z intensity in the frame `base_link`, with `ring` when every point has one, and `time`.
sensor_msgs::PointCloud2 toSensorCloud(const Scan& scan);

/// The pose in the frame `odom`, child `odom_mapping`.
nav_msgs::Odometry toOdometry(const Scan& scan);

/// The pose as the transform from `odom` to `base_link`.
geometry_msgs::TransformStamped toTransform(const Scan& scan);

/// One uint32 field `label` for each point, SemanticKITTI coding. @param truth as many as points
sensor_msgs::PointCloud2 toTruthCloud(const Scan& scan, const std::vector<std::uint32_t>& truth);

}  // namespace segdf

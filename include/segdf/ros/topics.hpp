// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Names of topics and frames as LIO-SAM's ROS 1 master has them.
namespace segdf::topics {

/// Full deskewed sweep in the odometry frame: the input of choice.
constexpr const char* kRegisteredCloud = "/lio_sam/mapping/cloud_registered_raw";
/// The same points in the sensor frame: the fall-back.
constexpr const char* kDeskewedCloud = "/lio_sam/deskew/cloud_deskewed";
/// Corner and surface features only, down-sampled: not usable, and refused.
constexpr const char* kFeatureCloud = "/lio_sam/mapping/cloud_registered";
/// Pose of the sensor, with the stamp of its cloud.
constexpr const char* kOdometry = "/lio_sam/mapping/odometry";
constexpr const char* kTf = "/tf";
constexpr const char* kTfStatic = "/tf_static";

constexpr const char* kCloudType = "sensor_msgs/PointCloud2";
constexpr const char* kOdometryType = "nav_msgs/Odometry";

constexpr const char* kOdometryFrame = "odom";
constexpr const char* kOdometryChildFrame = "odom_mapping";
constexpr const char* kSensorFrame = "base_link";

/// Ground truth beside a drive: one uint32 `label` for each point. No part of the filter reads it.
constexpr const char* kTruthLabels = "/segdf_truth/labels";

}  // namespace segdf::topics

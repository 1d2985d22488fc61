// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/buffer.h>

namespace segdf {

/// Where the sensor sits on what the odometry describes, by the static transforms that tf has.
class SensorMount {
 public:
  /// A cloud in the odometry's frame or in the sensor's, and the pose of the sensor.
  struct Seen {
    sensor_msgs::PointCloud2ConstPtr cloud;
    nav_msgs::Odometry odometry;
  };

  /// @param buffer outlives the mount
  /// @param base_frame what the odometry gives the pose of; empty: its child_frame_id
  /// @param sensor_frame empty: the cloud's frame, or base_frame where the cloud is in the
  /// odometry's frame
  SensorMount(const tf2_ros::Buffer& buffer, std::string base_frame, std::string sensor_frame);

  /// For one thread. Waits for a transform that is not there yet: once, for 5 s.
  /// @throws IoError naming the frames when tf does not connect them
  Seen apply(const sensor_msgs::PointCloud2ConstPtr& cloud, const nav_msgs::Odometry& odometry);

 private:
  geometry_msgs::TransformStamped lookUp(const std::string& target, const std::string& source);
  bool waitFor(const std::string& target, const std::string& source);

  const tf2_ros::Buffer& buffer_;
  std::string base_frame_;
  std::string sensor_frame_;
  bool waited_ = false;
};

}  // namespace segdf

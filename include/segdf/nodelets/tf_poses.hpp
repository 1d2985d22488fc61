// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include <tf2_ros/buffer.h>

#include "segdf/ros/cloud_queue.hpp"

namespace segdf {

/// Brings each cloud together with the sensor's pose at its stamp as tf has it: what Synchroniser
/// does with odometry. Clouds wait until tf has come so far: pairUp() is to be called now and then.
class TfPoses : public CloudQueue {
 public:
  /// @param buffer outlives this object
  /// @param sensor_frame empty: the cloud's own
  /// @param queue_size clouds that may wait for tf, at least 1
  TfPoses(const tf2_ros::Buffer& buffer,
          std::string map_frame,
          std::string sensor_frame,
          std::size_t queue_size,
          PairCallback on_pair);

 private:
  nav_msgs::OdometryConstPtr findPose(const sensor_msgs::PointCloud2& cloud) override;
  const std::string& sensorOf(const sensor_msgs::PointCloud2& cloud) const;

  const tf2_ros::Buffer& buffer_;
  std::string map_frame_;
  std::string sensor_frame_;
};

}  // namespace segdf

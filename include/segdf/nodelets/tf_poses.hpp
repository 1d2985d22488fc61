// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <string>

#include <tf2_ros/buffer.h>

#include "segdf/ros/synchroniser.hpp"

namespace segdf {

/// Brings each cloud together with the sensor's pose at its stamp as tf has it: what Synchroniser
/// does with odometry. Clouds wait until tf has come so far; they leave in their order, and every
/// one ends as a pair or is counted as unmatched.
class TfPoses {
 public:
  /// @param buffer outlives this object
  /// @param sensor_frame empty: the cloud's own
  /// @param queue_size clouds that may wait for tf, at least 1
  TfPoses(const tf2_ros::Buffer& buffer,
          std::string map_frame,
          std::string sensor_frame,
          std::size_t queue_size,
          Synchroniser::PairCallback on_pair);
  TfPoses(const TfPoses&) = delete;
  TfPoses& operator=(const TfPoses&) = delete;

  void addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);

  /// Looks whether tf has come farther: to be called now and then.
  void pairUp();

  const Synchroniser::Counts& counts() const { return counts_; }
  std::size_t waiting() const { return clouds_.size(); }

 private:
  bool pairOne();
  const std::string& sensorOf(const sensor_msgs::PointCloud2& cloud) const;

  const tf2_ros::Buffer& buffer_;
  std::string map_frame_;
  std::string sensor_frame_;
  std::size_t queue_size_;
  Synchroniser::PairCallback on_pair_;
  Synchroniser::Counts counts_;
  std::deque<sensor_msgs::PointCloud2ConstPtr> clouds_;  ///< in the order in which they came
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include <nav_msgs/Odometry.h>

#include "segdf/ros/cloud_queue.hpp"

namespace segdf {

/// Brings each cloud together with its pose, whichever comes first. Exact: the odometry message of
/// identical stamp. Approximate: where there is none, the pose at the cloud's stamp between the two
/// messages around it, the nearer of which is no farther than `slop`; that of one message where
/// only the later one is there. message_filters' policies do not say what becomes of a cloud
/// without partner; here every cloud ends as a pair or is counted as unmatched.
class Synchroniser : public CloudQueue {
 public:
  /// @param queue_size clouds that may wait for their pose, at least 1; poses may wait ten times
  /// @param slop seconds; 0 = identical stamps only
  Synchroniser(std::size_t queue_size, double slop, PairCallback on_pair);

  void addOdometry(const nav_msgs::OdometryConstPtr& odometry);

  /// Poses of a later time among those that wait for a cloud.
  std::size_t posesAfter(const ros::Time& stamp) const;

 private:
  /// Where in poses_ a cloud's pose is: one message twice, or the two around its stamp.
  struct Neighbours {
    std::size_t before = 0;
    std::size_t after = 0;
  };

  nav_msgs::OdometryConstPtr findPose(const sensor_msgs::PointCloud2& cloud) override;
  std::optional<Neighbours> find(const ros::Time& stamp) const;
  std::optional<Neighbours> findAround(const ros::Time& stamp) const;

  double slop_;
  std::deque<nav_msgs::OdometryConstPtr> poses_;  ///< in the order in which they came
};

/// The pose at a time between those of two messages: way and turn divided evenly.
/// @pre before.header.stamp <= stamp <= after.header.stamp
nav_msgs::Odometry interpolate(const nav_msgs::Odometry& before,
                               const nav_msgs::Odometry& after,
                               const ros::Time& stamp);

}  // namespace segdf

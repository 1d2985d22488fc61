// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include <message_filters/sync_policies/exact_time.h>
#include <message_filters/synchronizer.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

namespace segdf {

/// Brings each cloud together with the odometry message of identical stamp, whichever comes first.
/// Every cloud ends as a pair or is counted as unmatched: nothing is lost without being told.
class Synchroniser {
 public:
  using PairCallback = std::function<void(const sensor_msgs::PointCloud2ConstPtr&,
                                          const nav_msgs::OdometryConstPtr&)>;

  struct Counts {
    std::size_t clouds = 0;
    std::size_t poses = 0;
    std::size_t pairs = 0;
    std::size_t unmatched = 0;  ///< clouds given up: no pose came with their stamp
  };

  /// @param queue_size stamps that may wait for their other half, at least 1
  Synchroniser(std::size_t queue_size, PairCallback on_pair);
  Synchroniser(const Synchroniser&) = delete;
  Synchroniser& operator=(const Synchroniser&) = delete;

  void addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void addOdometry(const nav_msgs::OdometryConstPtr& odometry);

  const Counts& counts() const { return counts_; }

 private:
  using Policy =
      message_filters::sync_policies::ExactTime<sensor_msgs::PointCloud2, nav_msgs::Odometry>;

  void onPair(const sensor_msgs::PointCloud2ConstPtr& cloud,
              const nav_msgs::OdometryConstPtr& odometry);
  void onDrop(const sensor_msgs::PointCloud2ConstPtr& cloud,
              const nav_msgs::OdometryConstPtr& odometry);

  PairCallback on_pair_;
  Counts counts_;
  message_filters::Synchronizer<Policy> pairs_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <functional>

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

namespace segdf {

/// Clouds that wait for their pose, wherever that comes from. They leave in their order, and every
/// one ends as a pair or is counted as unmatched.
class CloudQueue {
 public:
  using PairCallback = std::function<void(const sensor_msgs::PointCloud2ConstPtr&,
                                          const nav_msgs::OdometryConstPtr&)>;

  struct Counts {
    std::size_t clouds = 0;
    std::size_t poses = 0;  ///< messages; stays 0 where poses come in another way
    std::size_t pairs = 0;
    std::size_t unmatched = 0;  ///< clouds given up: a later one has its pose, or too many wait
  };

  virtual ~CloudQueue() = default;
  CloudQueue(const CloudQueue&) = delete;
  CloudQueue& operator=(const CloudQueue&) = delete;

  void addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);

  /// Looks for poses that have come.
  void pairUp();

  const Counts& counts() const { return counts_; }
  /// Clouds whose pose may still come: clouds = pairs + unmatched + waiting.
  std::size_t waiting() const { return clouds_.size(); }

 protected:
  /// @param queue_size clouds that may wait, at least 1
  CloudQueue(std::size_t queue_size, PairCallback on_pair);

  std::size_t queueSize() const { return queue_size_; }
  void countPose() { ++counts_.poses; }

 private:
  /// The pose of a cloud, null while it has not come. Where it has, no earlier cloud will be asked
  /// for again.
  virtual nav_msgs::OdometryConstPtr findPose(const sensor_msgs::PointCloud2& cloud) = 0;
  bool pairOne();

  std::size_t queue_size_;
  PairCallback on_pair_;
  Counts counts_;
  std::deque<sensor_msgs::PointCloud2ConstPtr> clouds_;  ///< in the order in which they came
};

}  // namespace segdf

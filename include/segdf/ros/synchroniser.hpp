// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

namespace segdf {

/// Brings each cloud together with its pose, whichever comes first. Exact: the odometry message of
/// identical stamp. Approximate: where there is none, the pose at the cloud's stamp between the two
/// messages around it, the nearer of which is no farther than `slop`; that of one message where
/// only the later one is there. message_filters' policies do not say what becomes of a cloud
/// without partner; here every cloud ends as a pair or is counted as unmatched.
class Synchroniser {
 public:
  using PairCallback = std::function<void(const sensor_msgs::PointCloud2ConstPtr&,
                                          const nav_msgs::OdometryConstPtr&)>;

  struct Counts {
    std::size_t clouds = 0;
    std::size_t poses = 0;
    std::size_t pairs = 0;
    std::size_t unmatched = 0;  ///< clouds given up: a later one has its pose, or too many wait
  };

  /// @param queue_size clouds that may wait for their pose, at least 1; poses may wait ten times
  /// @param slop seconds; 0 = identical stamps only
  Synchroniser(std::size_t queue_size, double slop, PairCallback on_pair);
  Synchroniser(const Synchroniser&) = delete;
  Synchroniser& operator=(const Synchroniser&) = delete;

  void addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void addOdometry(const nav_msgs::OdometryConstPtr& odometry);

  const Counts& counts() const { return counts_; }
  /// Clouds whose pose may still come: clouds = pairs + unmatched + waiting.
  std::size_t waiting() const { return clouds_.size(); }

 private:
  /// Where in poses_ a cloud's pose is: one message twice, or the two around its stamp.
  struct Neighbours {
    std::size_t before = 0;
    std::size_t after = 0;
  };

  void pairUp();
  bool pairOne();
  std::optional<Neighbours> find(const ros::Time& stamp) const;
  std::optional<Neighbours> findAround(const ros::Time& stamp) const;

  std::size_t queue_size_;
  double slop_;
  PairCallback on_pair_;
  Counts counts_;
  std::deque<sensor_msgs::PointCloud2ConstPtr> clouds_;  ///< in the order in which they came
  std::deque<nav_msgs::OdometryConstPtr> poses_;         ///< likewise
};

/// The pose at a time between those of two messages: way and turn divided evenly.
/// @pre before.header.stamp <= stamp <= after.header.stamp
nav_msgs::Odometry interpolate(const nav_msgs::Odometry& before,
                               const nav_msgs::Odometry& after,
                               const ros::Time& stamp);

}  // namespace segdf

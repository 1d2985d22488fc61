// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/lio_sam_messages.hpp"

#include "ros/node_client.hpp"
#include "ros/sample_scan.hpp"

namespace segdf::test {

/// Gives the node, whose topics are not remapped, scans of random points, 0.1 s apart.
class ScanPublisher {
 public:
  explicit ScanPublisher(std::size_t points) : points_(points) {}

  /// The next scans, once the node listens.
  void publish(int scans) {
    ASSERT_TRUE(spinUntil(
        [this] { return cloud_.getNumSubscribers() > 0 && odometry_.getNumSubscribers() > 0; }));
    for (int k = 0; k < scans; ++k) {
      const Scan scan = sampleScan(points_, next_stamp_ns_);
      next_stamp_ns_ += 100'000'000;
      odometry_.publish(toOdometry(scan));
      cloud_.publish(toSensorCloud(scan));
    }
  }

  /// To be called when the node has gone: until that is known, scans would go to it.
  bool waitUntilAlone() const {
    return spinUntil(
        [this] { return cloud_.getNumSubscribers() + odometry_.getNumSubscribers() == 0; });
  }

 private:
  std::size_t points_;
  std::int64_t next_stamp_ns_ = 100'000'000'000;
  ros::NodeHandle node_;
  ros::Publisher cloud_ = node_.advertise<sensor_msgs::PointCloud2>("/cloud", kQueueSize);
  ros::Publisher odometry_ = node_.advertise<nav_msgs::Odometry>("/odometry", kQueueSize);
};

}  // namespace segdf::test

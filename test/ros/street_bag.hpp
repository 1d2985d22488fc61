// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "segdf/ros/lio_sam_messages.hpp"
#include "segdf/ros/topics.hpp"

#include "support/box_world.hpp"

namespace segdf::test {

/// A drive of 10 m/s along a street, 10 scans a second, as messages that a test can spoil before
/// they are written. Registered clouds unless told otherwise.
struct StreetBag {
  static constexpr double kStart = 1000.0;  ///< seconds
  static constexpr int kScans = 12;

  std::string cloud_topic = topics::kRegisteredCloud;
  std::string odometry_topic = topics::kOdometry;
  double received_after = 0.01;  ///< seconds, counted from the stamps before they were spoilt
  std::vector<sensor_msgs::PointCloud2> clouds;
  std::vector<nav_msgs::Odometry> poses;

  static StreetBag registered() { return StreetBag(scans(), true); }
  static StreetBag deskewed() { return StreetBag(scans(), false); }

  /// Scans of 64 x 500 rays, enough for normals and so for the misfit of poses.
  static std::vector<Scan> scans(int count = kScans, double metres_a_scan = 1.0) {
    const BoxWorld street = makeStreet();
    std::vector<Scan> result;
    for (int k = 0; k < count; ++k) {
      const auto stamp = static_cast<std::int64_t>(kStart * 1e9) + k * 100'000'000LL;
      result.push_back(street.scan(metres_a_scan * k, 0.0, 0.0, stamp, 500));
    }
    return result;
  }

  StreetBag(const std::vector<Scan>& drive, bool registered) {
    if (!registered) cloud_topic = topics::kDeskewedCloud;
    for (const Scan& scan : drive) {
      clouds.push_back(registered ? toRegisteredCloud(scan) : toSensorCloud(scan));
      poses.push_back(toOdometry(scan));
    }
  }

  /// Messages are received 0.1 s after each other, whatever their stamps say.
  void write(const std::filesystem::path& file) const {
    rosbag::Bag bag(file.string(), rosbag::bagmode::Write);
    const auto received = [this](std::size_t k) {
      return ros::Time(kStart + received_after + 0.1 * static_cast<double>(k));
    };
    for (std::size_t k = 0; k < poses.size(); ++k) bag.write(odometry_topic, received(k), poses[k]);
    for (std::size_t k = 0; k < clouds.size(); ++k) bag.write(cloud_topic, received(k), clouds[k]);
  }
};

/// Sets a float field of every `every`-th point.
inline void setField(sensor_msgs::PointCloud2& cloud,
                     const std::string& field,
                     float value,
                     std::size_t every = 1) {
  sensor_msgs::PointCloud2Iterator<float> at(cloud, field);
  for (std::size_t i = 0; at != at.end(); ++at, ++i) {
    if (i % every == 0) *at = value;
  }
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include <geometry_msgs/Pose.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "segdf/io/scan_source.hpp"

namespace segdf {

/// Which topics of a bag hold the drive. Empty names stand for LIO-SAM's (ros/topics.hpp): the
/// registered cloud if the bag has it, else the deskewed one. A leading slash more or less does not
/// matter.
struct BagTopics {
  std::string cloud;     ///< sensor_msgs/PointCloud2
  std::string odometry;  ///< nav_msgs/Odometry
};

/// A drive from a ROS 1 bag: every cloud with the pose of identical header stamp, in the order of
/// the bag. When a message was received does not matter. The bag is read twice and never held: the
/// poses and one chunk of the bag are all that stays in memory. No ROS master is needed.
class BagSource : public ScanSource {
 public:
  /// @throws IoError if the bag cannot be read, or if a topic is missing (the message lists those
  /// that the bag has), has another type, or is LIO-SAM's cloud of features
  explicit BagSource(const std::filesystem::path& bag, const BagTopics& topics = {});

  std::optional<Scan> next() override;
  /// Number of clouds with a pose.
  std::size_t size() const override { return size_; }
  std::string describe() const override;

  /// Number of clouds that are left out because no pose has their stamp.
  std::size_t unmatched() const { return unmatched_; }

  /// The topics that are read, as the bag spells them.
  const BagTopics& topics() const { return topics_; }

 private:
  void readPoses();
  void countClouds();
  std::optional<Scan> nextPair();

  std::filesystem::path file_;
  std::unique_ptr<rosbag::Bag> bag_;
  BagTopics topics_;
  std::string odometry_frame_;
  std::map<std::int64_t, geometry_msgs::Pose> poses_;  ///< by header stamp, nanoseconds
  std::size_t size_ = 0;
  std::size_t unmatched_ = 0;
  std::unique_ptr<rosbag::View> clouds_;
  rosbag::View::iterator position_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_access.hpp"

#include <fstream>
#include <string>

#include <rosbag/view.h>

namespace segdf {
namespace {

constexpr const char* kMagic = "#ROSBAG V";

/// Empty for a file that begins as ROS 1 bags do, else what it is.
std::string strangeness(const std::filesystem::path& file) {
  std::string start(std::string(kMagic).size(), '\0');
  std::ifstream(file, std::ios::binary)
      .read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start == kMagic) return "";
  const bool ros2 = start.rfind("SQLite", 0) == 0 || start.rfind("\x89MCAP", 0) == 0;
  return ros2 ? "it is a ROS 2 bag: convert it to ROS 1, e.g. with rosbags-convert"
              : "it does not begin with '" + std::string(kMagic) + "': it is no ROS 1 bag";
}

}  // namespace

void refuseBag(const std::filesystem::path& file, const std::exception& reason) {
  throw IoError("cannot read bag '" + file.string() + "' (" + reason.what() +
                "): if it was cut off, run 'rosbag reindex " + file.string() + "'");
}

std::unique_ptr<rosbag::Bag> openBag(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw IoError("bag '" + file.string() + "' does not exist or is no file: check the path");
  }
  const std::string strange = strangeness(file);
  if (!strange.empty()) throw IoError("cannot read bag '" + file.string() + "': " + strange);
  try {
    return std::make_unique<rosbag::Bag>(file.string());
  } catch (const std::exception& error) {
    refuseBag(file, error);
  }
}

TopicTypes topicTypes(const rosbag::Bag& bag) {
  TopicTypes types;
  rosbag::View all(bag);
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    types[connection->topic] = connection->datatype;
  }
  return types;
}

std::int64_t stampOf(const std_msgs::Header& header) {
  return static_cast<std::int64_t>(header.stamp.toNSec());
}

}  // namespace segdf

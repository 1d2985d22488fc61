// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_source.hpp"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/conversions.hpp"
#include "segdf/ros/topic_choice.hpp"

namespace segdf {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::exception& reason) {
  throw IoError("cannot read bag '" + file.string() + "' (" + reason.what() +
                "): if it was cut off, run 'rosbag reindex " + file.string() + "'");
}

std::unique_ptr<rosbag::Bag> openBag(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw IoError("bag '" + file.string() + "' does not exist or is no file: check the path");
  }
  try {
    return std::make_unique<rosbag::Bag>(file.string());
  } catch (const std::exception& error) {
    refuse(file, error);
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

template <class Message>
boost::shared_ptr<Message> read(const rosbag::MessageInstance& instance) {
  boost::shared_ptr<Message> message = instance.instantiate<Message>();
  if (message) return message;
  throw IoError("topic '" + instance.getTopic() + "' has " + instance.getDataType() +
                " messages of another definition than this ROS: convert the bag with rosbag fix");
}

/// A bag may be broken in the middle: next() gives what comes before, and tells when it gets there.
template <class Pass>
void asFarAsReadable(const Pass& pass) {
  try {
    pass();
  } catch (const IoError&) {
    throw;
  } catch (const std::exception&) {
    return;
  }
}

std::int64_t stampOf(const std_msgs::Header& header) {
  return static_cast<std::int64_t>(header.stamp.toNSec());
}

}  // namespace

BagSource::BagSource(const std::filesystem::path& bag, const BagTopics& topics)
    : file_(bag), bag_(openBag(bag)) {
  const std::string where = "bag '" + file_.string() + "'";
  const TopicTypes types = topicTypes(*bag_);
  topics_.cloud = chooseCloudTopic(types, topics.cloud, where);
  topics_.odometry = chooseOdometryTopic(types, topics.odometry, where);
  asFarAsReadable([this] { readPoses(); });
  asFarAsReadable([this] { countClouds(); });
  clouds_ = std::make_unique<rosbag::View>(*bag_, rosbag::TopicQuery(topics_.cloud));
  position_ = clouds_->begin();
}

void BagSource::readPoses() {
  rosbag::View view(*bag_, rosbag::TopicQuery(topics_.odometry));
  for (const rosbag::MessageInstance& instance : view) {
    const auto odometry = read<nav_msgs::Odometry>(instance);
    if (poses_.empty()) odometry_frame_ = odometry->header.frame_id;
    if (odometry->header.frame_id != odometry_frame_) {
      throw IoError("odometry on topic '" + topics_.odometry + "' changes its frame from '" +
                    odometry_frame_ + "' to '" + odometry->header.frame_id +
                    "': cut the bag where it does");
    }
    poses_.emplace(stampOf(odometry->header), odometry->pose.pose);
  }
}

void BagSource::countClouds() {
  rosbag::View view(*bag_, rosbag::TopicQuery(topics_.cloud));
  for (const rosbag::MessageInstance& instance : view) {
    const auto cloud = read<sensor_msgs::PointCloud2>(instance);
    ++(poses_.count(stampOf(cloud->header)) != 0 ? size_ : unmatched_);
  }
}

std::optional<Scan> BagSource::next() {
  try {
    return nextPair();
  } catch (const IoError&) {
    throw;
  } catch (const std::exception& error) {
    position_ = clouds_->end();
    refuse(file_, error);
  }
}

std::optional<Scan> BagSource::nextPair() {
  while (position_ != clouds_->end()) {
    const auto cloud = read<sensor_msgs::PointCloud2>(*position_);
    ++position_;
    const auto pose = poses_.find(stampOf(cloud->header));
    if (pose == poses_.end()) continue;
    nav_msgs::Odometry odometry;
    odometry.header.frame_id = odometry_frame_;
    odometry.pose.pose = pose->second;
    return toScan(*cloud, odometry, topics_.cloud);
  }
  return std::nullopt;
}

std::string BagSource::describe() const {
  return "bag " + file_.string() + " (" + std::to_string(size_) + " scans, clouds on " +
         topics_.cloud + ", poses on " + topics_.odometry + ")";
}

}  // namespace segdf

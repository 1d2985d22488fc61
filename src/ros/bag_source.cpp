// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_source.hpp"

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/bag_access.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/topic_choice.hpp"

namespace segdf {
namespace {

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
    const auto odometry = readMessage<nav_msgs::Odometry>(instance);
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
    const auto cloud = readMessage<sensor_msgs::PointCloud2>(instance);
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
    refuseBag(file_, error);
  }
}

std::optional<Scan> BagSource::nextPair() {
  while (position_ != clouds_->end()) {
    const auto cloud = readMessage<sensor_msgs::PointCloud2>(*position_);
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

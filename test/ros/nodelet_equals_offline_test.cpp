// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest (nodelet_equals_offline.test): the labels that the nodelet publishes against
// those that segdf_offline wrote for the same bag.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointCloud2;
using Labels = std::vector<std::uint32_t>;

constexpr std::uint32_t kQueueSize =
    1000;                           // more than scans in the bag: the test itself loses nothing
constexpr double kPatience = 60.0;  // seconds for any one thing to happen
constexpr double kSettled = 3.0;    // seconds without a new frame: the nodelet has done its queue

/// As SemanticKITTI has it: class below, instance above, 0 for instances that do not fit.
Labels labelsOf(const PointCloud2& cloud) {
  Labels labels;
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> instance(cloud, "instance");
  for (; label != label.end(); ++label, ++instance) {
    labels.push_back((*instance <= 0xFFFF ? *instance << 16U : 0U) | *label);
  }
  return labels;
}

Labels readLabels(const std::filesystem::path& file) {
  Labels labels(std::filesystem::file_size(file) / sizeof(std::uint32_t));
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(labels.data()),
            static_cast<std::streamsize>(labels.size() * sizeof(std::uint32_t)));
  return labels;
}

std::vector<std::filesystem::path> labelFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Spins until `done` holds. @return whether it did within kPatience
template <class Done>
bool spinUntil(const Done& done) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!done() && ros::WallTime::now() < end) {
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  return done();
}

class NodeletEqualsOffline : public ::testing::Test {
 protected:
  void listen() {
    labelled_ = node_.subscribe<PointCloud2>("/segdf/labelled_cloud", kQueueSize,
                                             [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
                                               frames_.push_back(labelsOf(*cloud));
                                               last_frame_ = ros::WallTime::now();
                                             });
    ASSERT_TRUE(spinUntil([this] { return labelled_.getNumPublishers() > 0; }))
        << "the nodelet does not come up";
    // Lets the player begin: it waits for a subscriber to each of its topics.
    truth_ = node_.subscribe<PointCloud2>(
        topics::kTruthLabels, kQueueSize,
        [this](const sensor_msgs::PointCloud2ConstPtr&) { ++scans_played_; });
  }

  void waitForTheEnd(std::size_t scans) {
    EXPECT_TRUE(spinUntil([&] { return scans_played_ >= scans; })) << "the bag does not play";
    // Its last messages are on their way; the nodelet may hold all frames back until it is flushed.
    const ros::WallTime played = ros::WallTime::now();
    EXPECT_TRUE(spinUntil([&] {
      const ros::WallTime latest = std::max(played, last_frame_);
      return (ros::WallTime::now() - latest).toSec() > kSettled;
    })) << "the nodelet does not come to an end";
  }

  void flush() {
    std_srvs::Trigger trigger;
    ASSERT_TRUE(ros::service::call("/segdf/flush", trigger));
    EXPECT_TRUE(trigger.response.success) << trigger.response.message;
  }

  ros::NodeHandle node_;
  ros::Subscriber labelled_;
  ros::Subscriber truth_;
  std::vector<Labels> frames_;
  ros::WallTime last_frame_;
  std::size_t scans_played_ = 0;
};

TEST_F(NodeletEqualsOffline, EveryPointOfEveryScan) {
  const auto files = labelFiles(ros::param::param<std::string>("~labels", ""));
  ASSERT_GE(files.size(), 20U) << "too short a drive says little";
  listen();
  waitForTheEnd(files.size());
  flush();
  EXPECT_TRUE(spinUntil([&] { return frames_.size() >= files.size(); }));
  ASSERT_EQ(frames_.size(), files.size()) << "scans lost, or given twice";
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Labels offline = readLabels(files[k]);
    ASSERT_EQ(frames_[k].size(), offline.size()) << files[k];
    EXPECT_TRUE(frames_[k] == offline) << "labels differ in scan " << k;
  }
}

// After the drive above, and nobody has listened to the map until now.
TEST_F(NodeletEqualsOffline, LateViewerGetsTheMap) {
  std::size_t points = 0;
  const ros::Subscriber map = node_.subscribe<PointCloud2>(
      "/segdf/static_map", 1, [&points](const sensor_msgs::PointCloud2ConstPtr& cloud) {
        EXPECT_EQ(cloud->header.frame_id, topics::kOdometryFrame);
        points = cloud->width;
      });
  EXPECT_TRUE(spinUntil([&points] { return points > 0; }));
}

}  // namespace
}  // namespace segdf

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "nodelet_equals_offline_test");
  return RUN_ALL_TESTS();
}

// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest (nodelet_drive.test.in): what the nodelet makes of a bag that is played,
// against what segdf_offline wrote for it.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/topics.hpp"

#include "ros/node_client.hpp"

namespace segdf {
namespace {

constexpr double kSettled = 0.5;  // seconds for what must not come

class NodeletDrive : public ::testing::Test {
 protected:
  /// Lets the player begin, which waits for a subscriber to each of its topics, once nothing of the
  /// nodelet can be missed.
  void play(std::size_t scans) {
    ASSERT_TRUE(test::spinUntil([this] { return client_.isConnected(); }))
        << "the nodelet does not come up";
    truth_ = node_.subscribe<sensor_msgs::PointCloud2>(
        topics::kTruthLabels, test::kQueueSize,
        [this](const sensor_msgs::PointCloud2ConstPtr&) { ++scans_played_; });
    EXPECT_TRUE(test::spinUntil([&] { return scans_played_ >= scans; })) << "the bag does not play";
    EXPECT_TRUE(client_.waitUntilReceived(scans)) << "clouds are lost on the way";
    test::NodeClient::flush();
    test::spinUntil([&] { return client_.frames.size() >= scans; });
    test::spinUntil([] { return false; }, kSettled);  // nothing may come twice
    ASSERT_FALSE(client_.reports.empty());
  }

  test::NodeClient client_;
  ros::NodeHandle node_;
  ros::Subscriber truth_;
  std::size_t scans_played_ = 0;
};

/// Share of points with the same label.
double agreement(const test::Labels& a, const test::Labels& b) {
  if (a.size() != b.size()) return 0.0;
  std::size_t same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) same += a[i] == b[i] ? 1 : 0;
  return static_cast<double>(same) / static_cast<double>(a.size());
}

TEST_F(NodeletDrive, LabelsAreThoseOfTheOfflineRunnerAndEveryPairIsAccountedFor) {
  const auto files = test::labelFiles(ros::param::param<std::string>("~labels", ""));
  ASSERT_GE(files.size(), 20U) << "too short a drive says little";
  play(files.size());
  const FrameReport& last = client_.reports.back();
  test::expectAccounted(last);
  EXPECT_EQ(last.clouds_received, files.size());
  EXPECT_EQ(last.scans_processed, files.size());
  EXPECT_EQ(last.jump_resets, static_cast<unsigned>(ros::param::param("~jumps", 0)));
  EXPECT_EQ(last.time_resets, 0U);
  EXPECT_EQ(client_.reports.size(), files.size());
  ASSERT_EQ(client_.frames.size(), files.size()) << "scans lost, or given twice";
  const double least = ros::param::param("~agreement", 1.0);
  for (std::size_t k = 0; k < files.size(); ++k) {
    EXPECT_GE(agreement(client_.frames[k], test::readLabels(files[k])), least) << files[k];
    EXPECT_EQ(client_.reports[k].index, k);
  }
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest (nodelet_silence.test): what the user reads when a topic is wrong.
#include <string>

#include <gtest/gtest.h>

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>
#include <sensor_msgs/PointCloud2.h>

#include "ros/node_client.hpp"

namespace segdf {
namespace {

TEST(NodeletSilence, WarningNamesTheTopicsExpectedAndThoseOnTheAir) {
  ros::NodeHandle node;
  const ros::Publisher cloud = node.advertise<sensor_msgs::PointCloud2>("/points_raw", 1);
  const ros::Publisher odometry = node.advertise<nav_msgs::Odometry>("/wheel_odometry", 1);
  std::string warning;
  const ros::Subscriber log = node.subscribe<rosgraph_msgs::Log>(
      "/rosout", 100, [&warning](const rosgraph_msgs::LogConstPtr& line) {
        const bool ours = line->msg.find("no cloud with a pose") != std::string::npos;
        if (line->level == rosgraph_msgs::Log::WARN && ours) warning = line->msg;
      });
  // 5 s of silence, and the time that the nodelet takes to load.
  ASSERT_TRUE(test::spinUntil([&warning] { return !warning.empty(); }, 30.0));
  for (const char* part : {"'/no/such/cloud': 0 came", "'/no/such/odometry': 0 came",
                           "clouds on /points_raw", "poses on /wheel_odometry", "cloud_topic"}) {
    EXPECT_NE(warning.find(part), std::string::npos) << part << " is not in: " << warning;
  }
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest: `rosbag play --loop` starts the nodelet anew each time.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include <ros/ros.h>

#include "ros/node_client.hpp"

namespace segdf {
namespace {

/// Without instances, whose ids go on from round to round.
test::Labels classesOf(test::Labels labels) {
  for (std::uint32_t& label : labels) label &= 0xFFFFU;
  return labels;
}

TEST(NodeletLoop, EveryRoundIsTheSame) {
  test::NodeClient client;
  const std::size_t scans = test::labelFiles(ros::param::param<std::string>("~labels", "")).size();
  ASSERT_GE(scans, 20U);
  ASSERT_TRUE(test::spinUntil([&] { return client.frames.size() >= 2 * scans; }))
      << "no second round";
  for (std::size_t k = 0; k < scans; ++k) {
    EXPECT_EQ(classesOf(client.frames[k]), classesOf(client.frames[scans + k])) << "scan " << k;
  }
  ASSERT_GE(client.reports.size(), 2 * scans);
  EXPECT_EQ(client.reports[scans - 1].time_resets, 0U);
  EXPECT_EQ(client.reports[2 * scans - 1].time_resets, 1U);
  EXPECT_EQ(client.reports[2 * scans - 1].scans_dropped, 0U);
  test::expectAccounted(client.reports.back());
}

}  // namespace
}  // namespace segdf

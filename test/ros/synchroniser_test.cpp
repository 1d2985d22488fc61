// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/synchroniser.hpp"

#include <cstdint>
#include <vector>

#include <boost/make_shared.hpp>
#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr std::size_t kQueueSize = 4;

class SynchroniserTest : public ::testing::Test {
 protected:
  void cloud(std::uint32_t second) {
    auto message = boost::make_shared<sensor_msgs::PointCloud2>();
    message->header.stamp = ros::Time(second, 0);
    synchroniser_.addCloud(message);
  }
  void odometry(std::uint32_t second) {
    auto message = boost::make_shared<nav_msgs::Odometry>();
    message->header.stamp = ros::Time(second, 0);
    synchroniser_.addOdometry(message);
  }

  std::vector<std::uint32_t> paired_;
  Synchroniser synchroniser_{kQueueSize, [this](const sensor_msgs::PointCloud2ConstPtr& cloud,
                                                const nav_msgs::OdometryConstPtr& odometry) {
                               EXPECT_EQ(cloud->header.stamp, odometry->header.stamp);
                               paired_.push_back(cloud->header.stamp.sec);
                             }};
};

TEST_F(SynchroniserTest, PairsWhicheverComesFirst) {
  odometry(1);
  cloud(1);
  cloud(2);
  odometry(2);
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(synchroniser_.counts().pairs, 2U);
  EXPECT_EQ(synchroniser_.counts().unmatched, 0U);
}

TEST_F(SynchroniserTest, WaitsAsLongAsTheQueueAllows) {
  for (std::uint32_t second = 1; second <= kQueueSize; ++second) cloud(second);
  for (std::uint32_t second = 1; second <= kQueueSize; ++second) odometry(second);
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST_F(SynchroniserTest, CloudWithoutPoseIsCountedWhenALaterPairComes) {
  cloud(1);
  cloud(2);
  odometry(2);
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(synchroniser_.counts().unmatched, 1U);
}

TEST_F(SynchroniserTest, CloudsThatNeverGetAPoseAreCountedNotHeld) {
  for (std::uint32_t second = 1; second <= 10; ++second) cloud(second);
  EXPECT_EQ(synchroniser_.counts().unmatched, 10U - kQueueSize);
}

TEST_F(SynchroniserTest, PosesWithoutCloudAreNoLoss) {
  for (std::uint32_t second = 1; second <= 10; ++second) odometry(second);
  cloud(10);
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{10}));
  EXPECT_EQ(synchroniser_.counts().unmatched, 0U);
}

TEST_F(SynchroniserTest, PairsAgainAfterTimeHasGoneBackwards) {
  for (const std::uint32_t second : {8U, 9U, 1U, 2U}) {
    odometry(second);
    cloud(second);
  }
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{8, 9, 1, 2}));
  EXPECT_EQ(synchroniser_.counts().unmatched, 0U);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/synchroniser.hpp"

#include <cmath>
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
  Synchroniser synchroniser_{kQueueSize, 0.0,
                             [this](const sensor_msgs::PointCloud2ConstPtr& cloud,
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

TEST_F(SynchroniserTest, CountsPosesWithoutCloudAfterATime) {
  for (std::uint32_t second = 1; second <= 4; ++second) odometry(second);
  cloud(2);
  EXPECT_EQ(synchroniser_.posesAfter(ros::Time(2, 0)), 2U);
  EXPECT_EQ(synchroniser_.posesAfter(ros::Time(4, 0)), 0U);
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

TEST_F(SynchroniserTest, EveryCloudIsAPairOrUnmatchedOrWaits) {
  for (const std::uint32_t second : {1U, 2U, 3U, 5U, 6U}) cloud(second);
  for (const std::uint32_t second : {2U, 4U, 5U}) odometry(second);
  const Synchroniser::Counts& counts = synchroniser_.counts();
  EXPECT_EQ(counts.pairs, 2U);
  EXPECT_EQ(counts.unmatched, 2U) << "1 and 3";
  EXPECT_EQ(synchroniser_.waiting(), 1U) << "6";
  EXPECT_EQ(counts.clouds, counts.pairs + counts.unmatched + synchroniser_.waiting());
}

TEST_F(SynchroniserTest, PairsAgainAfterTimeHasGoneBackwards) {
  for (const std::uint32_t second : {8U, 9U, 1U, 2U}) {
    odometry(second);
    cloud(second);
  }
  EXPECT_EQ(paired_, (std::vector<std::uint32_t>{8, 9, 1, 2}));
  EXPECT_EQ(synchroniser_.counts().unmatched, 0U);
}

/// Poses 0.1 s apart, at x = 10 times the stamp's seconds; clouds between them.
class ApproximateTest : public ::testing::Test {
 protected:
  void cloud(double seconds) {
    auto message = boost::make_shared<sensor_msgs::PointCloud2>();
    message->header.stamp = ros::Time(seconds);
    synchroniser_.addCloud(message);
  }
  void odometry(double seconds) {
    auto message = boost::make_shared<nav_msgs::Odometry>();
    message->header.stamp = ros::Time(seconds);
    message->header.frame_id = "odom";
    message->pose.pose.position.x = 10.0 * seconds;
    message->pose.pose.orientation.w = 1.0;
    synchroniser_.addOdometry(message);
  }

  std::vector<double> places_;
  Synchroniser synchroniser_{kQueueSize, 0.06,
                             [this](const sensor_msgs::PointCloud2ConstPtr& cloud,
                                    const nav_msgs::OdometryConstPtr& odometry) {
                               EXPECT_EQ(cloud->header.stamp, odometry->header.stamp);
                               EXPECT_EQ(odometry->header.frame_id, "odom");
                               places_.push_back(odometry->pose.pose.position.x);
                             }};
};

TEST_F(ApproximateTest, PoseIsThatAtTheCloudsOwnTime) {
  odometry(1.0);
  cloud(1.03);
  EXPECT_TRUE(places_.empty()) << "the pose after it is not there yet";
  odometry(1.1);
  ASSERT_EQ(places_.size(), 1U);
  EXPECT_NEAR(places_[0], 10.3, 1e-6);
  cloud(1.06);
  ASSERT_EQ(places_.size(), 2U) << "both poses serve again";
  EXPECT_NEAR(places_[1], 10.6, 1e-6);
}

TEST_F(ApproximateTest, PoseTooFarAwayIsNoPose) {
  odometry(1.0);
  cloud(1.1);
  odometry(1.2);
  EXPECT_TRUE(places_.empty()) << "0.1 s to either side";
  cloud(1.2);
  ASSERT_EQ(places_.size(), 1U);
  EXPECT_NEAR(places_[0], 12.0, 1e-9);
  EXPECT_EQ(synchroniser_.counts().unmatched, 1U);
}

TEST_F(ApproximateTest, TurnIsDividedEvenly) {
  nav_msgs::Odometry before;
  before.header.stamp = ros::Time(1.0);
  before.pose.pose.orientation.w = 1.0;
  nav_msgs::Odometry after = before;
  after.header.stamp = ros::Time(2.0);
  after.pose.pose.orientation.z = std::sin(0.2);  // 0.4 rad
  after.pose.pose.orientation.w = std::cos(0.2);
  const nav_msgs::Odometry between = interpolate(before, after, ros::Time(1.25));
  EXPECT_NEAR(between.pose.pose.orientation.z, std::sin(0.05), 1e-9);
}

}  // namespace
}  // namespace segdf

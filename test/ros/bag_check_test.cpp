// SPDX-License-Identifier: BSD-3-Clause
// Each finding of segdf_validate_bag on a bag that has just this one fault: bag, topics, stamps,
// frames. Poses and points are in bag_check_points_test.cpp.
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <topic_tools/shape_shifter.h>

#include <tf2_msgs/TFMessage.h>

#include "segdf/ros/topics.hpp"

#include "ros/bag_check_fixture.hpp"
#include "ros/broken_bag.hpp"

namespace segdf {
namespace {

using test::BagCheck;
using test::contains;
using test::StreetBag;

TEST_F(BagCheck, GoodRegisteredBagHasNothingToSay) {
  const BagReport report = check();
  expectGood(report);
  EXPECT_EQ(fact(report, "pairs"), "12 of 12 clouds have a pose of the same stamp");
  EXPECT_EQ(fact(report, "time"), "12 scans in 1.1 s, 10.0 a second");
  EXPECT_EQ(fact(report, "receipt"), "0.010 s after the stamp (median)");
  EXPECT_EQ(fact(report, "way"), "11.0 m, 10.0 m/s (median)");
  EXPECT_EQ(fact(report, "fields"), "x y z intensity (float32)");
  EXPECT_TRUE(contains(fact(report, "frames"), "registered"));
  EXPECT_TRUE(contains(fact(report, "sensor"), "hdl64 (64 lasers"));
  EXPECT_TRUE(contains(fact(report, "topic"), "/lio_sam/mapping/cloud_registered_raw"));
}

TEST_F(BagCheck, GoodDeskewedBagNamesItsTopicToTheLaunchFileOnly) {
  bag_ = StreetBag::deskewed();
  const BagReport report = check();
  expectGood(report);
  EXPECT_TRUE(contains(fact(report, "frames"), "seen from the sensor"));
  EXPECT_EQ(fact(report, "fields"), "x y z intensity (float32), ring (uint16), time (float32)");
  EXPECT_EQ(offlineCommand(file(), report.topics),
            "segdf_offline --bag " + file().string() + " --output result");
  EXPECT_EQ(launchCommand(file(), report.topics),
            "roslaunch segdf segdf.launch bag:=" + file().string() +
                " cloud_topic:=/lio_sam/deskew/cloud_deskewed rviz:=true");
}

TEST(BagCheckCommands, AreQuotedForTheShell) {
  const BagTopics topics{"/points", "/odom"};
  EXPECT_EQ(offlineCommand("my drive's.bag", topics),
            "segdf_offline --bag 'my drive'\\''s.bag' --cloud-topic /points --odometry-topic /odom "
            "--output result");
  EXPECT_EQ(launchCommand("/data/my drive.bag", topics),
            "roslaunch segdf segdf.launch 'bag:=/data/my drive.bag' cloud_topic:=/points "
            "odometry_topic:=/odom rviz:=true");
}

// Topics

TEST_F(BagCheck, TheOnlyTopicsOfTheirTypesAreTaken) {
  bag_.cloud_topic = "/points";
  bag_.odometry_topic = "/odom";
  const BagReport report = check();
  expectGood(report);
  EXPECT_EQ(report.topics.cloud, "/points");
  EXPECT_EQ(report.topics.odometry, "/odom");
}

TEST_F(BagCheck, OneOfSeveralCloudTopicsMustBeNamed) {
  bag_.cloud_topic = "/points";
  bag_.write(file());
  {
    rosbag::Bag more(file().string(), rosbag::bagmode::Append);
    more.write("/other", ros::Time(StreetBag::kStart), bag_.clouds.front());
  }
  expectError(checkBag(file(), {}), "name its cloud topic, one of: ");
  expectGood(checkBag(file(), {{"points", ""}, false}));
}

TEST_F(BagCheck, TheCloudOfFeaturesAloneIsRefusedWithTheReason) {
  bag_.cloud_topic = topics::kFeatureCloud;
  const BagReport report = check();
  expectError(report, "down-sampled corner and surface features");
  EXPECT_TRUE(
      contains(report.errors.front(), "record '/lio_sam/mapping/cloud_registered_raw' instead"));
}

TEST_F(BagCheck, TheCloudOfFeaturesIsRefusedWhenNamedToo) {
  bag_.cloud_topic = topics::kFeatureCloud;
  expectError(check({{topics::kFeatureCloud, ""}, false}), "features");
}

TEST_F(BagCheck, WithoutOdometryThereAreNoPoses) {
  bag_.poses.clear();
  expectError(check(), "has no topic '/lio_sam/mapping/odometry'");
}

TEST_F(BagCheck, WithoutOdometryTfMayKnowThePoses) {
  bag_ = StreetBag::deskewed();
  bag_.poses.clear();
  bag_.write(file());
  const auto add = [this](const std::string& topic, const char* parent, const char* child) {
    rosbag::Bag more(file().string(), rosbag::bagmode::Append);
    tf2_msgs::TFMessage tf;
    tf.transforms.resize(1);
    tf.transforms[0].header.frame_id = parent;
    tf.transforms[0].child_frame_id = child;
    more.write(topic, ros::Time(StreetBag::kStart), tf);
  };
  add("/tf_static", "vehicle", "base_link");
  expectError(checkBag(file(), {}), "has no topic '/lio_sam/mapping/odometry'");  // nothing moves
  add("/tf", "odom", "vehicle");
  expectError(
      checkBag(file(), {}),
      "cloud_topic:=/lio_sam/deskew/cloud_deskewed use_tf:=true map_frame:=odom rviz:=true");
}

TEST_F(BagCheck, RegisteredCloudsNeedTheFrameThatMovesInTheirs) {
  bag_.poses.clear();
  bag_.write(file());
  {
    rosbag::Bag more(file().string(), rosbag::bagmode::Append);
    tf2_msgs::TFMessage tf;
    tf.transforms.resize(1);
    tf.transforms[0].header.frame_id = "odom";
    tf.transforms[0].child_frame_id = "velodyne";
    more.write("/tf", ros::Time(StreetBag::kStart), tf);
  }
  expectError(checkBag(file(), {}), "use_tf:=true map_frame:=odom sensor_frame:=velodyne");
}

TEST_F(BagCheck, EmptyBagIsNamed) {
  bag_.poses.clear();
  bag_.clouds.clear();
  expectError(check(), "drive.bag' is empty");
}

TEST_F(BagCheck, BagThatBreaksOffIsUsableUpToThere) {
  bag_.write(file());
  test::breakLastCloud(file());
  expectWarning(checkBag(file(), {}), "can be read up to cloud 10 at 1.0 s only");
}

TEST_F(BagCheck, BagWithoutReadableCloudIsNot) {
  bag_.clouds.resize(1);
  bag_.write(file());
  test::breakLastCloud(file());
  expectError(checkBag(file(), {}), "no message on /lio_sam/mapping/cloud_registered_raw can be");
}

TEST_F(BagCheck, MessagesOfAnotherDefinition) {
  bag_.poses.clear();
  bag_.write(file());
  topic_tools::ShapeShifter old;
  old.morph("0123456789abcdef0123456789abcdef", "nav_msgs/Odometry", "Header header", "");
  std::vector<std::uint8_t> content(16);  // a header of zeros: its numbers and an empty frame
  ros::serialization::IStream stream(content.data(), static_cast<std::uint32_t>(content.size()));
  old.read(stream);
  {
    rosbag::Bag more(file().string(), rosbag::bagmode::Append);
    more.write(topics::kOdometry, ros::Time(StreetBag::kStart), old);
  }
  expectError(checkBag(file(), {}), "of another definition than this ROS");
}

TEST_F(BagCheck, CloudsWhoseSizesContradict) {
  for (auto& cloud : bag_.clouds) cloud.row_step = 1;
  expectError(check(), "is broken: row_step 1 is less than");
}

TEST_F(BagCheck, TopicOfAnotherType) {
  expectError(check({{topics::kOdometry, ""}, false}), "must be sensor_msgs/PointCloud2");
}

// Stamps

TEST_F(BagCheck, CloudsWithoutPoseAreCounted) {
  bag_.poses.erase(bag_.poses.begin() + 4);
  expectWarning(check(),
                "1 clouds have no pose of the same stamp on /lio_sam/mapping/odometry and "
                "are left out (the first is cloud 4 at 0.4 s); record both topics from start to "
                "end; live, sync_slop:=0.10 interpolates poses: 12 of 12 clouds then have one");
}

TEST_F(BagCheck, LioSamMapsFewerSweepsThanItDeskews) {
  std::vector<nav_msgs::Odometry> every_other;
  bag_ = StreetBag(StreetBag::scans(22), false);
  for (std::size_t k = 0; k < bag_.poses.size(); k += 2) every_other.push_back(bag_.poses[k]);
  bag_.poses = every_other;
  const BagReport report = check();
  expectGood(report);
  EXPECT_TRUE(contains(fact(report, "pairs"), "11 of 22 clouds"));
}

TEST_F(BagCheck, RoundedStampsAreTold) {
  for (nav_msgs::Odometry& pose : bag_.poses) pose.header.stamp += ros::Duration(0, 400);
  expectError(check(), "stamps were rounded on the way");
}

TEST_F(BagCheck, ConstantOffsetIsTold) {
  for (nav_msgs::Odometry& pose : bag_.poses) pose.header.stamp += ros::Duration(0.04);
  const BagReport report = check();
  expectError(report, "0.040000 s off (median; 0.040000 to 0.040000)");
  EXPECT_TRUE(contains(report.errors.front(), "a constant offset"));
  EXPECT_TRUE(contains(report.errors.front(),
                       "; live, sync_slop:=0.05 interpolates poses: 12 of 12 clouds"));
}

TEST_F(BagCheck, CloudsAfterTheLastPoseAreNotPromisedOne) {
  for (nav_msgs::Odometry& pose : bag_.poses) pose.header.stamp -= ros::Duration(0.04);
  const BagReport report = check();
  ASSERT_EQ(report.errors.size(), 1U);
  EXPECT_TRUE(contains(report.errors.front(), "sync_slop:=0.05 interpolates poses: 11 of 12"));
}

TEST_F(BagCheck, OdometryOfItsOwnRateIsTold) {
  for (std::size_t k = 0; k < bag_.poses.size(); ++k) {
    bag_.poses[k].header.stamp += ros::Duration(0.01 + 0.003 * static_cast<double>(k));
  }
  expectError(check(), "a rate of its own");
}

TEST_F(BagCheck, AnotherClockIsTold) {
  for (nav_msgs::Odometry& pose : bag_.poses) pose.header.stamp += ros::Duration(1.0e9);
  const BagReport report = check();
  expectError(report, "different clocks");
  EXPECT_FALSE(contains(report.errors.front(), "sync_slop"));
}

TEST_F(BagCheck, TimeThatGoesBack) {
  std::swap(bag_.clouds[5], bag_.clouds[7]);
  expectWarning(check(),
                "2 clouds are not later than one before and are left out (the first, cloud "
                "6 at 0.6 s, goes back in time)");
}

TEST_F(BagCheck, StampsThatComeTwice) {
  bag_.clouds.insert(bag_.clouds.begin() + 3, bag_.clouds[3]);
  expectWarning(check(), "(the first, cloud 4 at 0.3 s, has the same stamp)");
}

TEST_F(BagCheck, StampZeroIsNone) {
  for (auto& cloud : bag_.clouds) cloud.header.stamp = ros::Time(0, 0);
  for (auto& pose : bag_.poses) pose.header.stamp = ros::Time(0, 0);
  EXPECT_TRUE(contains(all(check().errors),
                       "12 clouds on /lio_sam/mapping/cloud_registered_raw "
                       "have stamp 0"));
}

TEST_F(BagCheck, GapsAreFound) {
  bag_ = StreetBag(StreetBag::scans(35), true);
  bag_.clouds.erase(bag_.clouds.begin() + 6, bag_.clouds.begin() + 25);
  const BagReport report = check();
  expectWarning(report, "1 gaps of more than 1.0 s between scans (2.0 s after cloud 5 at 0.5 s)");
}

TEST_F(BagCheck, TooFewScans) {
  bag_.clouds.resize(4);
  expectWarning(check(), "only 4 scans");
}

TEST_F(BagCheck, TooFewScansASecond) {
  for (std::size_t k = 0; k < bag_.clouds.size(); ++k) {
    const ros::Time stamp(StreetBag::kStart + 4.0 * static_cast<double>(k));
    bag_.clouds[k].header.stamp = bag_.poses[k].header.stamp = stamp;
  }
  expectWarning(check(), "only 0.25 scans a second");
}

TEST_F(BagCheck, ReceiptOnAnotherClockDoesNoHarm) {
  bag_.received_after = 1.0e8;
  const BagReport report = check();
  expectGood(report);
  EXPECT_TRUE(contains(fact(report, "receipt"), "by another clock; no harm"));
}

// Frames

TEST_F(BagCheck, OdometryThatChangesItsFrame) {
  bag_.poses.back().header.frame_id = "map";
  EXPECT_TRUE(contains(all(check().errors), "changes its frame from 'odom' to 'map'"));
}

TEST_F(BagCheck, CloudsThatChangeTheirFrame) {
  bag_.clouds.back().header.frame_id = "map";
  expectWarning(check(), "change their frame from 'odom' to 'map'");
}

TEST_F(BagCheck, EmptyFrame) {
  for (auto& cloud : bag_.clouds) cloud.header.frame_id.clear();
  EXPECT_TRUE(contains(all(check().warnings), "header.frame_id of the clouds is empty"));
}

TEST_F(BagCheck, PosesOfAnotherFrameThanTheClouds) {
  bag_ = StreetBag::deskewed();
  for (auto& pose : bag_.poses) pose.child_frame_id = "imu";
  expectWarning(check(), "poses are those of 'imu', clouds are in 'base_link'");
}

TEST_F(BagCheck, RegisteredCloudsWithAnotherFrame) {
  startFarAway(true);
  for (auto& cloud : bag_.clouds) cloud.header.frame_id = "map";
  EXPECT_TRUE(contains(all(check().errors), "they are registered; give them the frame_id"));
}

TEST_F(BagCheck, SensorCloudsInTheFrameOfTheOdometry) {
  startFarAway(false);
  for (auto& cloud : bag_.clouds) cloud.header.frame_id = "odom";
  EXPECT_TRUE(contains(all(check().errors), "they are seen from the sensor; give them its"));
}

TEST_F(BagCheck, BothFormsAreGoodFarFromTheOrigin) {
  for (const bool registered : {true, false}) {
    startFarAway(registered);
    std::filesystem::remove(file());
    expectGood(check());
  }
}

}  // namespace
}  // namespace segdf

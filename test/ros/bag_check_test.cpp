// SPDX-License-Identifier: BSD-3-Clause
// Each finding of segdf_validate_bag on a bag that has just this one fault.
#include "segdf/ros/bag_check.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/ros/topics.hpp"

#include "ros/broken_bag.hpp"
#include "ros/street_bag.hpp"
#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using test::contains;
using test::setField;
using test::StreetBag;

class BagCheck : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "drive.bag"; }

  BagReport check(const BagCheckOptions& options = {}) const {
    bag_.write(file());
    return checkBag(file(), options);
  }

  static std::string fact(const BagReport& report, const std::string& name) {
    for (const auto& [its_name, text] : report.facts) {
      if (its_name == name) return text;
    }
    return "";
  }

  static std::string all(const std::vector<std::string>& texts) {
    std::string joined;
    for (const std::string& text : texts) joined += text + "\n";
    return joined;
  }

  static void expectGood(const BagReport& report) {
    EXPECT_EQ(all(report.warnings), "");
    EXPECT_EQ(all(report.errors), "");
  }
  static void expectWarning(const BagReport& report, const std::string& part) {
    ASSERT_EQ(report.warnings.size(), 1U) << all(report.warnings);
    EXPECT_TRUE(contains(report.warnings.front(), part));
    EXPECT_EQ(all(report.errors), "");
  }
  static void expectError(const BagReport& report, const std::string& part) {
    ASSERT_EQ(report.errors.size(), 1U) << all(report.errors);
    EXPECT_TRUE(contains(report.errors.front(), part));
  }

  /// Moves clouds and poses, so that the drive begins 100 m from the origin.
  void startFarAway(bool registered) {
    std::vector<Scan> scans = StreetBag::scans();
    for (Scan& scan : scans) scan.pose.pretranslate(Eigen::Vector3d(100.0, 0.0, 0.0));
    bag_ = StreetBag(scans, registered);
  }

  test::TempFolder folder_;
  StreetBag bag_ = StreetBag::registered();
};

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

// Stamps

TEST_F(BagCheck, CloudsWithoutPoseAreCounted) {
  bag_.poses.erase(bag_.poses.begin() + 4);
  expectWarning(check(),
                "1 clouds have no pose of the same stamp on /lio_sam/mapping/odometry and "
                "are left out (the first is cloud 4 at 0.4 s)");
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
}

TEST_F(BagCheck, OdometryOfItsOwnRateIsTold) {
  for (std::size_t k = 0; k < bag_.poses.size(); ++k) {
    bag_.poses[k].header.stamp += ros::Duration(0.01 + 0.003 * static_cast<double>(k));
  }
  expectError(check(), "a rate of its own");
}

TEST_F(BagCheck, AnotherClockIsTold) {
  for (nav_msgs::Odometry& pose : bag_.poses) pose.header.stamp += ros::Duration(1.0e9);
  expectError(check(), "different clocks");
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

// Poses

TEST_F(BagCheck, LoopClosureIsAJump) {
  for (std::size_t k = 8; k < bag_.poses.size(); ++k) bag_.poses[k].pose.pose.position.y += 1.5;
  EXPECT_TRUE(contains(all(check().warnings),
                       "1 jumps of the pose, by up to 1.5 m (the first before cloud 8 at 0.8 s)"));
}

TEST_F(BagCheck, IncrementalOdometryIsNamedIfTheBagHasIt) {
  for (std::size_t k = 8; k < bag_.poses.size(); ++k) bag_.poses[k].pose.pose.position.y += 1.5;
  bag_.write(file());
  const std::string incremental = "/lio_sam/mapping/odometry_incremental";
  {
    rosbag::Bag more(file().string(), rosbag::bagmode::Append);
    more.write(incremental, ros::Time(StreetBag::kStart), bag_.poses.front());
  }
  EXPECT_TRUE(contains(all(checkBag(file(), {}).warnings),
                       "--odometry-topic " + incremental + " has none"));
}

TEST_F(BagCheck, BrakingAtTheLimitIsNoJump) {
  // 10 m/s^2 from 10 m/s to standstill, as no car does on a dry road.
  std::vector<Scan> scans = StreetBag::scans();
  for (std::size_t k = 0; k < scans.size(); ++k) {
    const double t = std::min(0.1 * static_cast<double>(k), 1.0);
    scans[k] = test::makeStreet().scan(10.0 * t - 5.0 * t * t, 0.0, 0.0, scans[k].stamp_ns, 500);
  }
  bag_ = StreetBag(scans, true);
  expectGood(check());
}

TEST_F(BagCheck, StandingIsNoFault) {
  bag_ = StreetBag(StreetBag::scans(StreetBag::kScans, 0.0), true);
  const BagReport report = check();
  expectGood(report);
  EXPECT_EQ(fact(report, "way"), "0.0 m, 0.0 m/s (median)");
}

TEST_F(BagCheck, InvalidPosesAreCounted) {
  bag_.poses[3].pose.pose.orientation.w = 0.0;
  bag_.poses[4].pose.pose.position.x = std::numeric_limits<double>::infinity();
  const BagReport report = check();
  EXPECT_TRUE(contains(all(report.warnings),
                       "2 poses on /lio_sam/mapping/odometry are not finite "
                       "or have no unit quaternion (the first is that of "
                       "cloud 3 at 0.3 s)"));
  EXPECT_EQ(all(report.errors), "");
}

TEST_F(BagCheck, InvalidPosesOnlyAreUnusable) {
  for (auto& pose : bag_.poses) pose.pose.pose.orientation.w = 0.0;
  expectError(check(), "there is no other");
}

TEST_F(BagCheck, PosesThatDoNotFitTheScans) {
  bag_ = StreetBag::deskewed();
  for (std::size_t k = 0; k < bag_.poses.size(); k += 2) bag_.poses[k].pose.pose.position.y += 0.4;
  EXPECT_TRUE(contains(all(check().warnings), "poses do not fit the scans: consecutive scans"));
}

// Points

TEST_F(BagCheck, CloudWithoutIntensity) {
  for (auto& cloud : bag_.clouds) cloud.fields[3].name = "reflectivity";
  expectError(check(), "has no field 'intensity' (fields: x y z reflectivity)");
}

TEST_F(BagCheck, CoordinatesMustBeFloats) {
  for (auto& cloud : bag_.clouds) cloud.fields[0].datatype = sensor_msgs::PointField::INT32;
  expectError(check(), "has field 'x' as int32; segdf needs float32");
}

TEST_F(BagCheck, ConstantIntensity) {
  for (auto& cloud : bag_.clouds) setField(cloud, "intensity", 7.0F);
  expectWarning(check(), "intensity is 7.00 in every point");
}

TEST_F(BagCheck, IntensityThatIsNoNumber) {
  for (auto& cloud : bag_.clouds) setField(cloud, "intensity", test::kNan, 4);
  expectWarning(check(), "25.0 % of the intensities are NaN");
}

TEST_F(BagCheck, MostlyNaN) {
  for (auto& cloud : bag_.clouds) {
    for (std::size_t every : {2U, 3U, 5U, 7U, 11U, 13U}) setField(cloud, "x", test::kNan, every);
    setField(cloud, "x", test::kNan);
    *sensor_msgs::PointCloud2Iterator<float>(cloud, "x") = 5.0F;
  }
  EXPECT_TRUE(contains(all(check().warnings), "100.0 % of the points are NaN"));
}

TEST_F(BagCheck, NothingButNaN) {
  for (auto& cloud : bag_.clouds) setField(cloud, "y", test::kNan);
  expectError(check(), "no scan that was looked into has a point with finite coordinates");
}

TEST_F(BagCheck, ThinnedClouds) {
  std::vector<Scan> scans = StreetBag::scans();
  for (Scan& scan : scans) {
    std::vector<Point> kept;
    for (std::size_t i = 0; i < scan.points.size(); i += 20) kept.push_back(scan.points[i]);
    scan.points = kept;
  }
  bag_ = StreetBag(scans, true);
  EXPECT_TRUE(contains(all(check().warnings), "points a scan (median): thinned, or features only"));
}

TEST_F(BagCheck, EmptyCloudsAreCounted) {
  sensor_msgs::PointCloud2Modifier(bag_.clouds[6]).resize(0);
  EXPECT_TRUE(contains(all(check().warnings),
                       "1 clouds have no points and are left out (the first is cloud 6 at 0.6 s)"));
}

TEST_F(BagCheck, UnknownSensorNamesTheNearest) {
  std::vector<Scan> scans = StreetBag::scans();
  for (Scan& scan : scans) {
    // The lower half of the field of view of an HDL-64E is that of no sensor we know.
    const auto upper = [](const Point& p) { return p.ring < 32; };
    scan.points.erase(std::remove_if(scan.points.begin(), scan.points.end(), upper),
                      scan.points.end());
  }
  bag_ = StreetBag(scans, false);
  EXPECT_TRUE(contains(all(check().warnings), "unknown sensor (32 lasers"));
}

TEST_F(BagCheck, AllScansFindsWhatTheSampleDoesNot) {
  bag_ = StreetBag(StreetBag::scans(60), true);
  // Of 60 scans, 0 1 5 6 11 12 ... are looked into.
  setField(bag_.clouds[3], "x", test::kNan);
  expectGood(check());
  const BagReport report = checkBag(file(), {{}, true});
  expectWarning(report, "1 of 60 scans looked into have no point with finite coordinates");
}

}  // namespace
}  // namespace segdf

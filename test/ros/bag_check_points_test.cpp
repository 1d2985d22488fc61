// SPDX-License-Identifier: BSD-3-Clause
// Each finding of segdf_validate_bag on a bag that has just this one fault: poses, points.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/pipeline/pipeline.hpp"
#include "segdf/ros/topics.hpp"

#include "ros/bag_check_fixture.hpp"
#include "support/flushed.hpp"

namespace segdf {
namespace {

using test::BagCheck;
using test::contains;
using test::setField;
using test::StreetBag;

// Poses

TEST_F(BagCheck, LoopClosureIsAJump) {
  for (std::size_t k = 8; k < bag_.poses.size(); ++k) bag_.poses[k].pose.pose.position.y += 1.5;
  EXPECT_TRUE(contains(all(check().warnings),
                       "1 jumps of the pose by more than input.max_jump = 1.0 m (the first before "
                       "cloud 8 at 0.8 s)"));
}

TEST_F(BagCheck, JumpsAreThoseAtWhichThePipelineStartsAnew) {
  // Steps on both sides of what is explained: max_jump of 1 m and 0.1 m of braking.
  for (const double step : {0.5, 0.9, 1.05, 1.2, 3.0}) {
    std::vector<Scan> scans = StreetBag::scans();
    for (std::size_t k = 6; k < scans.size(); ++k) scans[k].pose.translation().y() += step;
    Pipeline pipeline(Config{}, 1);
    std::size_t restarts = 0;
    const auto count = [&restarts](const std::vector<FrameResult>& frames) {
      for (const FrameResult& frame : frames) restarts += frame.after_jump ? 1 : 0;
    };
    for (const Scan& scan : scans) count(pipeline.process(scan));
    count(test::flushed(pipeline));
    bag_ = StreetBag(scans, false);
    const std::string warnings = all(check().warnings);
    EXPECT_EQ(contains(warnings, "jumps of the pose"), restarts > 0) << step << " m\n" << warnings;
    EXPECT_EQ(restarts, step > 1.1 ? 1U : 0U) << step << " m";
    std::filesystem::remove(file());
  }
}

TEST_F(BagCheck, APoseThatTurnsAtOnceIsTold) {
  std::vector<Scan> scans = StreetBag::scans();
  for (std::size_t k = 6; k < scans.size(); ++k) {
    scans[k].pose.rotate(Eigen::AngleAxisd(0.8, Eigen::Vector3d::UnitZ()));
  }
  bag_ = StreetBag(scans, false);
  const std::string warnings = all(check().warnings);
  EXPECT_TRUE(contains(warnings,
                       "1 poses turn by more than 180 degrees a second (the first before cloud 6"));
  EXPECT_FALSE(contains(warnings, "jumps of the pose"));
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

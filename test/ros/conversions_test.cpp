// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/conversions.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "segdf/ros/cloud_fields.hpp"
#include "segdf/ros/lio_sam_messages.hpp"

#include "ros/sample_scan.hpp"
#include "support/expect_error.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr std::int64_t kStamp = 1'500'000'000'123'456'789;

/// The line that reading the cloud fails with; empty if it does not.
std::string refusal(const PointCloud2& cloud) {
  return test::errorOf([&] { toScan(cloud, toOdometry(test::sampleScan(1, kStamp)), "/points"); });
}

/// A cloud of one point at (1, 2, 3) m with an intensity, and perhaps another field, of any type.
template <class Number>
PointCloud2 onePoint(const std::string& field, std::uint8_t datatype, Number value) {
  PointCloud2 cloud;
  for (const char* name : {"x", "y", "z"}) addField(cloud, name, PointField::FLOAT32);
  if (field != "intensity") addField(cloud, "intensity", PointField::FLOAT32);
  addField(cloud, field, datatype);
  cloud.header.stamp.fromNSec(kStamp);
  cloud.header.frame_id = "lidar";
  cloud.width = 1;
  cloud.height = 1;
  cloud.row_step = cloud.point_step;
  cloud.data.resize(cloud.row_step, 0);
  const float position[] = {1.0F, 2.0F, 3.0F};
  std::memcpy(cloud.data.data(), position, sizeof(position));
  std::memcpy(&cloud.data[cloud.fields.back().offset], &value, sizeof(value));
  return cloud;
}

template <class Number>
Point readPoint(const std::string& field, std::uint8_t datatype, Number value) {
  const PointCloud2 cloud = onePoint(field, datatype, value);
  return toScan(cloud, toOdometry(test::sampleScan(1, kStamp))).points.at(0);
}

void expectSamePoints(const Scan& a, const Scan& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    // float32 at 150 m from the origin resolves 1.5e-5 m; 1e-3 m is the bound that the filter
    // needs.
    EXPECT_LT((a.points[i].position() - b.points[i].position()).norm(), 1e-3F) << "point " << i;
    EXPECT_EQ(a.points[i].intensity, b.points[i].intensity) << "point " << i;
  }
}

TEST(ToScan, SensorFormComesBackAsItWas) {
  const Scan scan = test::sampleScan(500, kStamp);
  const Scan read = toScan(toSensorCloud(scan), toOdometry(scan));
  EXPECT_EQ(read.stamp_ns, kStamp);
  EXPECT_TRUE(read.pose.isApprox(scan.pose, 1e-12));
  expectSamePoints(read, scan);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    EXPECT_EQ(read.points[i].position(), scan.points[i].position());
    EXPECT_EQ(read.points[i].ring, scan.points[i].ring);
    EXPECT_EQ(read.points[i].time, scan.points[i].time);
  }
}

TEST(ToScan, BothCloudFormsGiveTheSameScan) {
  const Scan scan = test::sampleScan(500, kStamp);
  const Scan registered = toScan(toRegisteredCloud(scan), toOdometry(scan));
  EXPECT_EQ(registered.stamp_ns, kStamp);
  expectSamePoints(registered, toScan(toSensorCloud(scan), toOdometry(scan)));
}

TEST(ToScan, NumbersOfASensorCloudAreAligned) {
  const Scan scan = test::sampleScan(10, kStamp);
  const PointCloud2 cloud = toSensorCloud(scan);
  for (const sensor_msgs::PointField& field : cloud.fields) {
    EXPECT_EQ(field.offset % datatypeSize(field.datatype), 0U) << field.name;
  }
  EXPECT_EQ(cloud.point_step % sizeof(float), 0U);
}

TEST(ToScan, NanPointsStayInTheirPlace) {
  Scan scan = test::sampleScan(10, kStamp);
  scan.points[4].y = std::numeric_limits<float>::quiet_NaN();
  for (const PointCloud2& cloud : {toRegisteredCloud(scan), toSensorCloud(scan)}) {
    const Scan read = toScan(cloud, toOdometry(scan));
    ASSERT_EQ(read.points.size(), 10U);
    for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(isFinite(read.points[i]), i != 4);
  }
}

TEST(ToScan, EmptyCloudGivesEmptyScan) {
  const Scan scan = test::sampleScan(0, kStamp);
  EXPECT_TRUE(toScan(toSensorCloud(scan), toOdometry(scan)).points.empty());
}

TEST(ToScan, IntensityMayBeAnyNumber) {
  EXPECT_EQ(readPoint("intensity", PointField::INT8, std::int8_t{-7}).intensity, -7.0F);
  EXPECT_EQ(readPoint("intensity", PointField::UINT8, std::uint8_t{200}).intensity, 200.0F);
  EXPECT_EQ(readPoint("intensity", PointField::INT16, std::int16_t{-300}).intensity, -300.0F);
  EXPECT_EQ(readPoint("intensity", PointField::UINT16, std::uint16_t{60000}).intensity, 60000.0F);
  EXPECT_EQ(readPoint("intensity", PointField::INT32, std::int32_t{-70000}).intensity, -70000.0F);
  EXPECT_EQ(readPoint("intensity", PointField::UINT32, std::uint32_t{70000}).intensity, 70000.0F);
  EXPECT_EQ(readPoint("intensity", PointField::FLOAT32, 0.25F).intensity, 0.25F);
  EXPECT_EQ(readPoint("intensity", PointField::FLOAT64, 0.5).intensity, 0.5F);
}

TEST(ToScan, TimesOfEveryConventionAreSecondsAfterTheStamp) {
  const double epoch = static_cast<double>(kStamp) * 1e-9;
  EXPECT_NEAR(readPoint("time", PointField::FLOAT32, 0.05F).time, 0.05F, 1e-7F);
  EXPECT_NEAR(readPoint("t", PointField::UINT32, std::uint32_t{50'000'000}).time, 0.05F, 1e-7F);
  // A double holds today's epoch seconds to 2.4e-7.
  EXPECT_NEAR(readPoint("timestamp", PointField::FLOAT64, epoch + 0.05).time, 0.05F, 1e-6F);
}

TEST(ToScan, RingThatCannotBeIsUnknown) {
  EXPECT_EQ(readPoint("ring", PointField::UINT16, std::uint16_t{63}).ring, 63);
  EXPECT_EQ(readPoint("ring", PointField::UINT8, std::uint8_t{127}).ring, 127);
  EXPECT_EQ(readPoint("ring", PointField::UINT16, std::uint16_t{65535}).ring, -1);
}

TEST(ToScan, RowsMayBePadded) {
  const Scan scan = test::sampleScan(6, kStamp);
  const PointCloud2 flat = toSensorCloud(scan);
  PointCloud2 padded = flat;
  padded.height = 2;
  padded.width = 3;
  padded.row_step = 3 * flat.point_step + 8;
  padded.data.assign(2 * padded.row_step, 0xFF);
  for (std::size_t row = 0; row < 2; ++row) {
    const std::size_t bytes = 3 * flat.point_step;
    std::memcpy(&padded.data[row * padded.row_step], &flat.data[row * bytes], bytes);
  }
  expectSamePoints(toScan(padded, toOdometry(scan)), scan);
}

TEST(ToScan, MissingIntensityNamesTheFields) {
  PointCloud2 cloud = toRegisteredCloud(test::sampleScan(3, kStamp));
  cloud.fields[3].name = "i";
  EXPECT_EQ(
      refusal(cloud),
      "cloud on topic '/points' has no field 'intensity' (fields: x y z i); segdf needs x y z "
      "intensity: publish or rename it");
}

TEST(ToScan, CoordinatesInDoubleAreRefused) {
  PointCloud2 cloud = onePoint("intensity", PointField::FLOAT64, 1.0);
  cloud.fields[0].offset = cloud.fields[3].offset;
  cloud.fields[0].datatype = PointField::FLOAT64;
  EXPECT_EQ(refusal(cloud),
            "cloud on topic '/points' has field 'x' as float64; segdf needs float32: convert it");
}

TEST(ToScan, BrokenLayoutsAreRefused) {
  const PointCloud2 good = toRegisteredCloud(test::sampleScan(3, kStamp));
  ASSERT_EQ(refusal(good), "");
  PointCloud2 big_endian = good;
  big_endian.is_bigendian = 1;
  EXPECT_NE(refusal(big_endian).find("big-endian"), std::string::npos);
  PointCloud2 ragged = good;
  ragged.data.pop_back();
  EXPECT_NE(refusal(ragged).find("47 bytes of data, row_step x height = 48"), std::string::npos);
  PointCloud2 short_rows = good;
  short_rows.row_step = 47;
  EXPECT_NE(refusal(short_rows).find("row_step 47 is less"), std::string::npos);
  PointCloud2 outside = good;
  outside.fields[3].offset = 13;
  EXPECT_NE(refusal(outside).find("ends at byte 17 of points of 16 bytes"), std::string::npos);
  PointCloud2 undefined = good;
  undefined.fields[3].datatype = 42;
  EXPECT_NE(refusal(undefined).find("datatype 42"), std::string::npos);
}

TEST(ToScan, QuaternionWithoutLengthGivesAnInvalidPose) {
  const Scan scan = test::sampleScan(3, kStamp);
  nav_msgs::Odometry odometry = toOdometry(scan);
  odometry.pose.pose.orientation = geometry_msgs::Quaternion();  // all zero: never filled in
  const Scan read = toScan(toRegisteredCloud(scan), odometry);
  EXPECT_FALSE(isValidPose(read.pose));
  EXPECT_EQ(read.points.size(), 3U);
}

}  // namespace
}  // namespace segdf

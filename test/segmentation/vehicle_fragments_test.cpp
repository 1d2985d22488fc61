// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/vehicle_fragments.hpp"

#include <set>

#include <gtest/gtest.h>

#include "segdf/segmentation/segmenter.hpp"

#include "support/box_world.hpp"

namespace segdf {
namespace {

constexpr float kSensorHeight = 1.73F;

/// The long side of a box, 9.5 m ahead.
test::BoxWorld boxAhead(double height) {
  test::BoxWorld world;
  world.add(10.0, 0.0, 1.0, 4.0, height);
  return world;
}

/// Higher than the sensor's lasers look over.
test::BoxWorld carAhead() { return boxAhead(1.5); }

/// Points one over the other, from a height over ground up. @returns the index of the first
std::size_t addColumn(Scan& scan, float x, float y, float height, int count, float step) {
  const std::size_t first = scan.points.size();
  for (int k = 0; k < count; ++k) {
    Point p = scan.points.front();
    p.x = x;
    p.y = y;
    p.z = height + step * static_cast<float>(k) - kSensorHeight;
    p.ring = static_cast<std::int16_t>(k);
    scan.points.push_back(p);
  }
  return first;
}

std::vector<std::int32_t> segmentOfPoints(const Scan& scan, const Config& config) {
  StageTimes times;
  const Segmentation seg = segmentScan(scan, config, 1, times);
  std::vector<std::int32_t> of_point(scan.points.size(), Clusters::kNoise);
  for (std::size_t s = 0; s < seg.segments.size(); ++s) {
    for (std::uint32_t i : seg.segments[s].points) of_point[i] = static_cast<std::int32_t>(s);
  }
  return of_point;
}

/// Segments of the points from `first` on.
std::set<std::int32_t> segmentsFrom(std::size_t first, const std::vector<std::int32_t>& of_point) {
  return {of_point.begin() + static_cast<std::ptrdiff_t>(first), of_point.end()};
}

/// The segment of the middle of the car's side.
std::int32_t segmentOfCar(const Scan& scan, const std::vector<std::int32_t>& of_point) {
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Point& p = scan.points[i];
    if (p.x > 9.4F && p.x < 9.6F && std::abs(p.y) < 0.5F && std::abs(p.z + 1.0F) < 0.3F) {
      return of_point[i];
    }
  }
  return Clusters::kNoise;
}

Config withoutVehicles() {
  Config config;
  config.vehicle.length = 0.0;
  return config;
}

TEST(VehicleFragments, WhatIsSeenThroughAWindowBelongsToTheCar) {
  Scan scan = carAhead().scan(0.0, 0.0, 0.0, 0, 2048);
  const std::size_t first = addColumn(scan, 10.9F, 0.2F, 1.0F, 5, 0.05F);
  const std::set<std::int32_t> noise{Clusters::kNoise};
  ASSERT_EQ(segmentsFrom(first, segmentOfPoints(scan, withoutVehicles())), noise)
      << "the scene is too easy";
  const auto of_point = segmentOfPoints(scan, {});
  ASSERT_GE(segmentOfCar(scan, of_point), 0);
  EXPECT_EQ(segmentsFrom(first, of_point), std::set<std::int32_t>{segmentOfCar(scan, of_point)});
}

/// Five points at a place are of no segment.
void expectNoise(const test::BoxWorld& world, float x, float y, float height) {
  Scan scan = world.scan(0.0, 0.0, 0.0, 0, 2048);
  const std::size_t first = addColumn(scan, x, y, height, 5, 0.05F);
  EXPECT_EQ(segmentsFrom(first, segmentOfPoints(scan, {})),
            std::set<std::int32_t>{Clusters::kNoise});
}

TEST(VehicleFragments, WhatIsFartherBehindThanACarIsWideDoesNot) {
  expectNoise(carAhead(), 12.5F, 0.2F, 1.0F);
}
TEST(VehicleFragments, WhatIsBesideItDoesNot) { expectNoise(carAhead(), 10.0F, 2.9F, 1.0F); }
TEST(VehicleFragments, WhatIsInFrontDoesNot) { expectNoise(carAhead(), 8.5F, 0.2F, 1.0F); }
TEST(VehicleFragments, WhatIsHigherDoesNot) { expectNoise(carAhead(), 10.9F, 0.2F, 1.9F); }

TEST(VehicleFragments, OverABonnetItsOwnRoofIsSeen) {
  Scan scan = boxAhead(1.0).scan(0.0, 0.0, 0.0, 0, 2048);
  const std::size_t first = addColumn(scan, 11.2F, 0.2F, 1.35F, 5, 0.04F);
  const auto of_point = segmentOfPoints(scan, {});
  ASSERT_GE(segmentOfCar(scan, of_point), 0);
  EXPECT_EQ(segmentsFrom(first, of_point), std::set<std::int32_t>{segmentOfCar(scan, of_point)});
  expectNoise(boxAhead(1.0), 11.2F, 0.2F, 1.7F);
}

TEST(VehicleFragments, OverAVanAnotherIsSeen) { expectNoise(boxAhead(1.65), 11.2F, 0.2F, 1.68F); }

TEST(VehicleFragments, AWallHasNone) {
  test::BoxWorld world;
  world.add(10.0, 0.0, 1.0, 14.0, 1.5);
  expectNoise(world, 10.9F, 0.2F, 1.0F);
}

TEST(VehicleFragments, SmallClustersGoAlongAndWhatIsAsHighAsAPersonDoesNot) {
  Scan low = carAhead().scan(0.0, 0.0, 0.0, 0, 2048);
  const std::size_t first = addColumn(low, 10.9F, 0.2F, 1.0F, 12, 0.03F);
  ASSERT_EQ(segmentsFrom(first, segmentOfPoints(low, withoutVehicles())).count(Clusters::kNoise),
            0U);
  const auto of_low = segmentOfPoints(low, {});
  EXPECT_EQ(segmentsFrom(first, of_low), std::set<std::int32_t>{segmentOfCar(low, of_low)});

  Scan high = carAhead().scan(0.0, 0.0, 0.0, 0, 2048);
  addColumn(high, 10.9F, 0.2F, 0.6F, 16, 0.06F);
  const auto of_high = segmentOfPoints(high, {});
  EXPECT_EQ(segmentsFrom(first, of_high).count(segmentOfCar(high, of_high)), 0U);
}

TEST(VehicleFragments, TheShorterWayRoundTheImageCounts) {
  EXPECT_EQ(columnsBetween(2040, 5, 2048), 13);
  EXPECT_EQ(columnsBetween(5, 2040, 2048), -13);
  EXPECT_EQ(columnsBetween(100, 900, 2048), 800);
}

}  // namespace
}  // namespace segdf

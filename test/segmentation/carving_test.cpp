// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/carving.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "segdf/segmentation/segmenter.hpp"

#include "support/box_world.hpp"

namespace segdf {
namespace {

constexpr double kSensorHeight = 1.73;

Config uncarved() {
  Config config;
  config.person.jump = 0.0;
  config.bicycle.jump = 0.0;
  return config;
}

std::vector<std::int32_t> segmentOfPoints(const Scan& scan, const Config& config, int threads = 1) {
  StageTimes times;
  const Segmentation seg = segmentScan(scan, config, threads, times);
  std::vector<std::int32_t> of_point(scan.points.size(), Clusters::kNoise);
  for (std::size_t s = 0; s < seg.segments.size(); ++s) {
    for (std::uint32_t i : seg.segments[s].points) of_point[i] = static_cast<std::int32_t>(s);
  }
  return of_point;
}

/// Part of a scene, from 0.3 m over ground up. Metres.
struct Area {
  double x0, x1, y0, y1;

  bool contains(const Point& p) const {
    const auto x = static_cast<double>(p.x);
    const auto y = static_cast<double>(p.y);
    return x > x0 && x < x1 && y > y0 && y<y1&& static_cast<double>(p.z)> 0.3 - kSensorHeight;
  }
};

/// Segments that points in the area belong to.
std::set<std::int32_t> segmentsIn(const Scan& scan,
                                  const std::vector<std::int32_t>& of_point,
                                  const Area& area) {
  std::set<std::int32_t> segments;
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    if (area.contains(scan.points[i])) segments.insert(of_point[i]);
  }
  return segments;
}

/// As many columns as the range image has.
Scan scanOf(const test::BoxWorld& world) {
  constexpr int kColumns = 2048;
  return world.scan(0.0, 0.0, 0.0, 0, kColumns);
}

/// Both areas are of one segment without carving, and of one each, not the same, with it.
void expectParted(const test::BoxWorld& world, const Area& a, const Area& b) {
  const Scan scan = scanOf(world);
  const auto whole = segmentOfPoints(scan, uncarved());
  ASSERT_EQ(segmentsIn(scan, whole, a), segmentsIn(scan, whole, b)) << "the scene is too easy";
  const auto carved = segmentOfPoints(scan, {});
  const auto of_a = segmentsIn(scan, carved, a);
  const auto of_b = segmentsIn(scan, carved, b);
  ASSERT_EQ(of_a.size(), 1U);
  ASSERT_EQ(of_b.size(), 1U);
  EXPECT_NE(*of_a.begin(), *of_b.begin());
  EXPECT_GE(*of_a.begin(), 0);
}

/// The wall's front stands `behind` metres behind the person's.
test::BoxWorld personAtWall(double behind) {
  test::BoxWorld world;
  world.add(10.0, 0.0, 0.2, 0.5, 1.7);
  world.add(9.9 + behind + 0.15, 0.0, 0.3, 8.0, 2.6);
  return world;
}

const Area kPerson{9.7, 10.05, -0.3, 0.3};
const Area kWall{10.1, 10.8, 1.0, 4.0};

TEST(Carving, APersonBesideAWallIsCarvedOffIt) { expectParted(personAtWall(0.35), kPerson, kWall); }

TEST(Carving, APersonWhoLeansAtTheWallIsNot) {
  const Scan scan = scanOf(personAtWall(0.05));
  EXPECT_EQ(segmentOfPoints(scan, {}), segmentOfPoints(scan, uncarved()));
}

TEST(Carving, APersonAmongChairsKeepsWhatIsSeenOfHim) {
  test::BoxWorld world;
  world.add(10.0, 0.0, 0.3, 4.0, 0.8);
  world.add(10.4, 0.0, 0.3, 0.5, 1.7);
  world.add(10.9, 0.0, 0.3, 4.0, 0.8);
  expectParted(world, {10.2, 10.6, -0.3, 0.3}, {9.8, 10.2, 0.5, 2.0});
}

/// Spokes and frame as upright bars 3 cm wide over a low base: one sees through.
test::BoxWorld bicycleAtFence(double spacing) {
  test::BoxWorld world;
  world.add(8.0, 0.0, 0.03, 1.6, 0.2);
  for (double y = -0.8; y < 0.81; y += spacing) world.add(8.0, y, 0.03, 0.03, 1.1);
  world.add(8.35, 0.0, 0.1, 6.0, 1.3);
  return world;
}

const Area kBicycle{7.9, 8.1, -0.9, 0.9};
const Area kFence{8.2, 8.5, 1.2, 3.0};

TEST(Carving, ABicycleAtAFenceIsCarvedOffIt) {
  expectParted(bicycleAtFence(0.1), kBicycle, kFence);
}

TEST(Carving, ABoardAtAFenceIsNot) {
  const Scan scan = scanOf(bicycleAtFence(0.02));
  EXPECT_EQ(segmentOfPoints(scan, {}), segmentOfPoints(scan, uncarved()));
}

TEST(Carving, TwoParkedCarsThatTouchAHedgeLoseNothing) {
  test::BoxWorld world;
  world.add(8.0, 4.0, 4.2, 1.8, 0.9);
  world.add(7.8, 4.0, 2.0, 1.6, 1.5);
  world.add(13.0, 4.0, 4.2, 1.8, 1.5);
  world.add(10.0, 5.2, 12.0, 0.6, 1.2);
  const Scan scan = scanOf(world);
  EXPECT_EQ(segmentOfPoints(scan, {}), segmentOfPoints(scan, uncarved()));
}

TEST(Carving, ACarIsNotCutIntoStripsBySensorsWithHalfTheColumns) {
  test::BoxWorld world;
  world.add(10.0, 3.85, 1.8, 1.7, 1.6);
  const Scan scan = world.scan(0.0, 0.0, 0.0, 0, 1000);
  const auto of_point = segmentOfPoints(scan, {});
  EXPECT_EQ(of_point, segmentOfPoints(scan, uncarved()));
  EXPECT_EQ(segmentsIn(scan, of_point, {9.0, 11.0, 2.9, 4.8}).size(), 1U);
}

TEST(Carving, ARiderStaysOnHisBicycle) {
  test::BoxWorld world;
  world.add(10.0, 0.0, 0.1, 1.8, 1.0);
  world.add(9.8, 0.0, 0.3, 0.5, 1.7);
  const Scan scan = scanOf(world);
  const auto of_point = segmentOfPoints(scan, {});
  EXPECT_EQ(of_point, segmentOfPoints(scan, uncarved()));
  EXPECT_EQ(segmentsIn(scan, of_point, {9.0, 11.0, -1.0, 1.0}).size(), 1U);
}

TEST(Carving, TwoPersonsSideBySideAreTwo) {
  test::BoxWorld world;
  world.add(10.0, -0.25, 0.3, 0.45, 1.7);
  world.add(10.35, 0.3, 0.3, 0.45, 1.75);
  expectParted(world, {9.7, 10.17, -0.6, 0.05}, {10.17, 10.6, 0.1, 0.6});
}

TEST(Carving, SegmentsAreLargeEnoughAndTheSameWithTwoThreads) {
  const Scan scan = scanOf(personAtWall(0.35));
  StageTimes times;
  const Segmentation seg = segmentScan(scan, {}, 1, times);
  ASSERT_EQ(seg.segments.size(), seg.clusters.count);
  for (const Segment& s : seg.segments) EXPECT_GE(s.points.size(), 10U);
  EXPECT_EQ(segmentOfPoints(scan, {}), segmentOfPoints(scan, {}, 2));
}

}  // namespace
}  // namespace segdf

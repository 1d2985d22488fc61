// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/segmenter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

Segmentation segment(const Scan& scan, const Config& config = {}, int threads = 1) {
  StageTimes times;
  return segmentScan(scan, config, threads, times);
}

std::vector<std::int32_t> segmentOfPoint(const Scan& scan, const Segmentation& seg) {
  std::vector<std::int32_t> of_point(scan.points.size(), -1);
  for (std::size_t s = 0; s < seg.segments.size(); ++s) {
    for (std::uint32_t i : seg.segments[s].points) of_point[i] = static_cast<std::int32_t>(s);
  }
  return of_point;
}

test::BoxWorld streetWithCars() {
  test::BoxWorld world = test::makeStreet();
  world.add(8.0, 4.0, 4.2, 1.8, 1.5);
  world.add(14.0, 4.0, 4.2, 1.8, 1.5);
  world.add(9.0, -4.0, 0.5, 0.5, 1.7);
  return world;
}

TEST(Segmenter, EachCarIsOneSegmentAndItsPointsAreInNoOther) {
  const Scan scan = streetWithCars().scan(0.0, 0.0, 0.0, 0);
  const Segmentation seg = segment(scan);
  const auto of_point = segmentOfPoint(scan, seg);
  for (double x : {8.0, 14.0}) {
    std::map<std::int32_t, int> votes;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const Point& p = scan.points[i];
      const bool on_car = std::abs(static_cast<double>(p.x) - x) < 2.2 &&
                          std::abs(static_cast<double>(p.y) - 4.0) < 1.0 && p.z > -1.3F;
      if (on_car) ++votes[of_point[i]];
    }
    EXPECT_EQ(votes.size(), 1U) << "car at " << x;
    EXPECT_EQ(votes.count(-1), 0U);
  }
}

TEST(Segmenter, EveryUsedPointIsGroundOrObjectAndSegmentsAreDisjoint) {
  const Scan scan = streetWithCars().scan(0.0, 0.0, 0.0, 0);
  const Segmentation seg = segment(scan);
  std::vector<int> uses(scan.points.size(), 0);
  for (const Segment& s : seg.segments) {
    EXPECT_TRUE(std::is_sorted(s.points.begin(), s.points.end()));
    for (std::uint32_t i : s.points) {
      ++uses[i];
      ASSERT_EQ(seg.roles[i], PointRole::kObject);
    }
  }
  EXPECT_LE(*std::max_element(uses.begin(), uses.end()), 1);
}

/// method.md 6.11: turning the scan moves the seam and the cells, but hardly a point changes its
/// cluster.
TEST(Segmenter, RotatingTheAzimuthOriginChangesLessThanOnePercent) {
  const Scan scan = streetWithCars().scan(0.0, 0.0, 0.0, 0);
  const Segmentation seg = segment(scan);
  const auto before = segmentOfPoint(scan, seg);
  for (float degrees : {37.3F, 90.0F, 181.7F, 300.1F}) {
    Scan turned = scan;
    const Eigen::AngleAxisf turn(degrees * 3.14159265F / 180.0F, Eigen::Vector3f::UnitZ());
    for (Point& p : turned.points) {
      const Eigen::Vector3f x = turn * p.position();
      p.x = x.x();
      p.y = x.y();
    }
    const auto after = segmentOfPoint(turned, segment(turned));
    std::map<std::int32_t, std::map<std::int32_t, int>> votes;
    for (std::size_t i = 0; i < before.size(); ++i) ++votes[before[i]][after[i]];
    int agree = 0;
    for (const auto& [cluster, counts] : votes) {
      int most = 0;
      for (const auto& [other, count] : counts) most = std::max(most, count);
      agree += most;
    }
    EXPECT_GT(agree, 0.99 * static_cast<double>(before.size())) << degrees << " degrees";
  }
}

TEST(Segmenter, SameOnTwoThreads) {
  const Scan scan = streetWithCars().scan(0.0, 0.0, 10.0, 0);
  EXPECT_EQ(segmentOfPoint(scan, segment(scan, {}, 1)), segmentOfPoint(scan, segment(scan, {}, 2)));
}

TEST(SelectPoints, RangeEgoBoxAndNaN) {
  InputConfig config;
  config.ego_box = {-1.0, 3.0, -1.0, 1.0};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const std::vector<Point> points{{0.5F, 0.5F, 0, 0, 0, -1},  {2.5F, 0, 0, 0, 0, -1},
                                  {3.5F, 0, 0, 0, 0, -1},     {119.0F, 0, 0, 0, 0, -1},
                                  {121.0F, 0, 0, 0, 0, -1},   {nan, 5.0F, 0, 0, 0, -1},
                                  {5.0F, 5.0F, inf, 0, 0, -1}};
  const std::vector<PointRole> roles = selectPoints(points, config);
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != PointRole::kUnused) used.push_back(i);
  }
  EXPECT_EQ(used, (std::vector<std::size_t>{2, 3}));
}

TEST(Segmenter, SurvivesHostileScans) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Scan all_nan;
  all_nan.points.assign(100, {nan, nan, nan, nan, 0.0F, -1});
  EXPECT_TRUE(segment(all_nan).segments.empty());
  EXPECT_EQ(segment(all_nan).non_finite_points, 100U);
  Scan coincident;
  coincident.points.assign(5000, {5.0F, 1.0F, 0.5F, 0.3F, 0.0F, -1});
  EXPECT_EQ(segment(coincident).segments.size(), 1U);
  Scan huge;
  huge.points.assign(50, {1e30F, 1e30F, 1e30F, 0.3F, 0.0F, -1});
  EXPECT_TRUE(segment(huge).segments.empty());
  Scan one;
  one.points.push_back({5.0F, 0.0F, 0.0F, 0.1F, 0.0F, -1});
  EXPECT_TRUE(segment(one).segments.empty());
}

}  // namespace
}  // namespace segdf

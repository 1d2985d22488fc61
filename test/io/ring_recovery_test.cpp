// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

/// Rings as the scanner numbered them, and the scan without them.
std::vector<std::int16_t> takeRings(Scan& scan) {
  std::vector<std::int16_t> rings;
  for (Point& p : scan.points) {
    rings.push_back(p.ring);
    p.ring = -1;
  }
  return rings;
}

void expectSameRings(const Scan& scan, const std::vector<std::int16_t>& rings) {
  // Rings without any return leave no trace, so numbers may be smaller; equal must stay equal.
  for (std::size_t i = 1; i < rings.size(); ++i) {
    if (!isFinite(scan.points[i]) || !isFinite(scan.points[i - 1])) continue;
    ASSERT_EQ(scan.points[i].ring == scan.points[i - 1].ring, rings[i] == rings[i - 1]) << i;
  }
}

TEST(RingRecovery, CounterClockwiseFromAhead) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const auto rings = takeRings(scan);
  ASSERT_TRUE(recoverRings(scan.points));
  expectSameRings(scan, rings);
}

TEST(RingRecovery, ClockwiseAndFromAnyAzimuthWhenTheFirstRingIsWhole) {
  test::BoxWorld yard;
  for (double side : {-12.0, 12.0}) {
    yard.add(side, 0.0, 1.0, 25.0, 8.0);
    yard.add(0.0, side, 25.0, 1.0, 8.0);
  }
  Scan scan = yard.scan(0.0, 0.0, 0.0, 0);
  const Eigen::AngleAxisf turn(2.1F, Eigen::Vector3f::UnitZ());
  for (Point& p : scan.points) {
    const Eigen::Vector3f x = turn * p.position();
    p.x = x.x();
    p.y = -x.y();  // mirrored: the sweep runs the other way
  }
  const auto rings = takeRings(scan);
  ASSERT_TRUE(recoverRings(scan.points));
  expectSameRings(scan, rings);
}

TEST(RingRecovery, FromTheLowestLaserUp) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  std::stable_sort(scan.points.begin(), scan.points.end(),
                   [](const Point& a, const Point& b) { return a.ring > b.ring; });
  const auto rings = takeRings(scan);
  ASSERT_TRUE(recoverRings(scan.points));
  expectSameRings(scan, rings);
}

TEST(RingRecovery, NaNPointsDoNotBreakARing) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  for (std::size_t i = 0; i < scan.points.size(); i += 17) {
    scan.points[i].x = std::numeric_limits<float>::quiet_NaN();
  }
  const auto rings = takeRings(scan);
  ASSERT_TRUE(recoverRings(scan.points));
  expectSameRings(scan, rings);
}

TEST(RingRecovery, AnInterleavedScanIsLeftAlone) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  // One firing of all lasers after the other, as a raw HDL-32E stream has it.
  std::stable_sort(scan.points.begin(), scan.points.end(), [](const Point& a, const Point& b) {
    return std::atan2(a.y, a.x) < std::atan2(b.y, b.x);
  });
  takeRings(scan);
  EXPECT_FALSE(recoverRings(scan.points));
  for (const Point& p : scan.points) ASSERT_EQ(p.ring, -1);
}

TEST(RingRecovery, NothingAndNonsense) {
  std::vector<Point> none;
  EXPECT_FALSE(recoverRings(none));
  std::vector<Point> same(1000);
  EXPECT_FALSE(recoverRings(same));
}

}  // namespace
}  // namespace segdf

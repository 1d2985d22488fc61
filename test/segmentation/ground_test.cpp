// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "segdf/segmentation/arc_tangent.hpp"

#include "support/box_world.hpp"

namespace segdf {
namespace {

using test::BoxWorld;

std::vector<PointRole> allUsed(const Scan& scan) {
  return std::vector<PointRole>(scan.points.size(), PointRole::kObject);
}

Ground groundOf(const Scan& scan, int threads = 1) {
  return extractGround(scan.points, allUsed(scan), turnsOf(scan.points), GroundConfig{},
                       RangeImageConfig{}, threads);
}

/// Height of a point above z = 0 of the world.
double worldHeight(const Scan& scan, std::size_t i) {
  return (scan.pose * scan.points[i].position().cast<double>()).z();
}

/// Share of points for which `is_ground` says what the world says; `low` are the ground's points.
struct Score {
  double recall = 0.0;
  double precision = 0.0;
};

Score score(const Scan& scan, const Ground& ground) {
  double hit = 0.0;
  double truth = 0.0;
  double marked = 0.0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const bool low = worldHeight(scan, i) < 1e-3;
    truth += low ? 1.0 : 0.0;
    marked += ground.is_ground[i] != 0 ? 1.0 : 0.0;
    hit += low && ground.is_ground[i] != 0 ? 1.0 : 0.0;
  }
  return {hit / truth, hit / marked};
}

TEST(Ground, FlatStreetIsFound) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const Score result = score(scan, groundOf(scan));
  // All but patches of fewer than n_min points; walls give only the points within th_dist of the
  // ground.
  EXPECT_GT(result.recall, 0.98);
  EXPECT_GT(result.precision, 0.97);
}

TEST(Ground, ABoxIsNotGroundAboveTheDistanceThreshold) {
  BoxWorld world;
  world.add(10.0, 0.0, 4.0, 1.8, 1.5);
  const Scan scan = world.scan(0.0, 0.0, 0.0, 0);
  const Ground ground = groundOf(scan);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    // 0.125 m threshold plus the pull of the box's lowest points on the plane.
    if (worldHeight(scan, i) > 0.25) {
      ASSERT_EQ(ground.is_ground[i], 0) << worldHeight(scan, i);
    }
  }
}

TEST(Ground, ASlopeIsGround) {
  Scan scan = BoxWorld().scan(0.0, 0.0, 0.0, 0);
  // A road that falls by 10 % ahead: tilt the whole scan about the sensor's foot.
  const Eigen::Vector3f foot(0.0F, 0.0F, -1.73F);
  const Eigen::AngleAxisf tilt(0.0997F, Eigen::Vector3f::UnitY());
  for (Point& p : scan.points) {
    const Eigen::Vector3f x = tilt * (p.position() - foot) + foot;
    p.x = x.x();
    p.y = x.y();
    p.z = x.z();
  }
  const Ground ground = groundOf(scan);
  std::size_t marked = 0;
  for (std::uint8_t g : ground.is_ground) marked += g;
  EXPECT_GT(static_cast<double>(marked), 0.95 * static_cast<double>(scan.points.size()));
}

TEST(Ground, HeightOfTheSensorIsMeasured) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  EXPECT_NEAR(
      estimateSensorHeight(scan.points, allUsed(scan), turnsOf(scan.points), GroundConfig{}), 1.73,
      0.02);
}

TEST(Ground, HeightOverGroundFollowsTheWorld) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const std::vector<float> height = heightOverGround(scan.points, groundOf(scan), 80.0);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    // Farther out a cell may hold nothing but a wall's foot.
    if (scan.points[i].position().norm() > 25.0F) continue;
    // A wall's foot within th_dist counts as ground and lifts its cell, a little more where it
    // tilts the plane.
    ASSERT_NEAR(static_cast<double>(height[i]), worldHeight(scan, i), 1.5 * GroundConfig{}.th_dist);
  }
}

TEST(Ground, ReflectionsBelowTheRoadAreNotGround) {
  Scan scan = BoxWorld().scan(0.0, 0.0, 0.0, 0);
  const std::size_t first = scan.points.size();
  for (const Point& p : test::randomBlob({6.0, 0.0, -4.0}, {1.0, 1.0, 0.2}, 40, 1)) {
    scan.points.push_back(p);
  }
  const Ground ground = groundOf(scan);
  for (std::size_t i = first; i < scan.points.size(); ++i) ASSERT_EQ(ground.is_ground[i], 0);
  EXPECT_GT(score(scan, ground).precision, 0.99);
}

TEST(Ground, UnusedPointsAreNeverGround) {
  const Scan scan = BoxWorld().scan(0.0, 0.0, 0.0, 0);
  std::vector<PointRole> roles = allUsed(scan);
  for (std::size_t i = 0; i < roles.size(); i += 2) roles[i] = PointRole::kUnused;
  const Ground ground = extractGround(scan.points, roles, turnsOf(scan.points), GroundConfig{},
                                      RangeImageConfig{}, 1);
  for (std::size_t i = 0; i < roles.size(); i += 2) ASSERT_EQ(ground.is_ground[i], 0);
}

TEST(Ground, NothingAndTooLittleGiveNoGround) {
  EXPECT_TRUE(groundOf(Scan{}).is_ground.empty());
  Scan few;
  few.points = test::randomBlob({5.0, 0.0, -1.7}, {0.1, 0.1, 0.01}, 9, 2);
  for (std::uint8_t g : groundOf(few).is_ground) EXPECT_EQ(g, 0);
}

TEST(Ground, SameOnTwoThreads) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 30.0, 0);
  EXPECT_EQ(groundOf(scan, 1).is_ground, groundOf(scan, 2).is_ground);
}

/// Wet roads and windows mirror: a few points of each patch lie metres below ground.
TEST(Ground, ReflectionsBelowGroundDoNotSinkAPatch) {
  const Scan clean = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  Scan mirrored = clean;
  for (std::size_t i = 0; i < clean.points.size(); i += 100) {
    Point p = clean.points[i];
    p.z = -3.0F - 0.1F * std::hypot(p.x, p.y);
    mirrored.points.push_back(p);
  }
  const Ground before = groundOf(clean);
  const Ground after = groundOf(mirrored);
  double kept = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    all += before.is_ground[i];
    kept += before.is_ground[i] != 0 && after.is_ground[i] != 0 ? 1.0 : 0.0;
  }
  EXPECT_GT(kept, 0.99 * all);
  for (std::size_t i = clean.points.size(); i < mirrored.points.size(); ++i) {
    ASSERT_EQ(after.is_ground[i], 0);
  }
}

/// More of them in one patch than give the seed height, in one plane, and not as deep: without them
/// it is fitted anew, and the road beside it is not taken to float over them.
TEST(Ground, ManyReflectionsInOnePatchLeaveTheRoadThereGround) {
  const Scan clean = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  Scan mirrored = clean;
  for (int k = 0; k < 30; ++k) {
    const auto step = static_cast<float>(k);
    mirrored.points.push_back({6.0F + 0.02F * step, 0.5F + 0.03F * step, -2.6F, 0.0F, 0.0F, -1});
  }
  const Ground before = groundOf(clean);
  const Ground after = groundOf(mirrored);
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    ASSERT_EQ(after.is_ground[i], before.is_ground[i]) << i;
  }
  for (std::size_t i = clean.points.size(); i < mirrored.points.size(); ++i) {
    ASSERT_EQ(after.is_ground[i], 0);
  }
}

/// A car's roof that fills its patch is as flat as ground.
TEST(Ground, AFloatingPatchIsNoGround) {
  test::BoxWorld world;
  world.add(18.0, 0.0, 5.0, 14.0, 1.0);
  const Scan scan = world.scan(0.0, 0.0, 0.0, 0);
  const Ground ground = groundOf(scan);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (worldHeight(scan, i) > 0.9) {
      ASSERT_EQ(ground.is_ground[i], 0);
    }
  }
}

/// Behind a wall the lowest line that is seen of a car has nothing below it in its patch; the road
/// is seen beside the wall.
TEST(Ground, ACarWhoseFootIsHiddenIsNoGround) {
  test::BoxWorld world;
  world.add(20.0, 1.5, 0.2, 3.5, 1.2);
  world.add(31.0, 2.2, 6.0, 1.8, 1.0);
  const Scan scan = world.scan(0.0, 0.0, 0.0, 0);
  const Ground ground = groundOf(scan);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (scan.points[i].x < 27.5F || worldHeight(scan, i) < 0.5) continue;
    ++seen;
    ASSERT_EQ(ground.is_ground[i], 0) << worldHeight(scan, i);
  }
  EXPECT_GT(seen, 10U);
}

/// Half of the scan missing: the other half is judged as before.
TEST(Ground, HalfAScanIsEnough) {
  const Scan whole = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  Scan half;
  std::vector<std::size_t> index;
  for (std::size_t i = 0; i < whole.points.size(); ++i) {
    if (whole.points[i].y < 0.0F) continue;
    half.points.push_back(whole.points[i]);
    index.push_back(i);
  }
  half.pose = whole.pose;
  EXPECT_NEAR(
      estimateSensorHeight(half.points, allUsed(half), turnsOf(half.points), GroundConfig{}), 1.73,
      0.02);
  const Ground of_whole = groundOf(whole);
  const Ground of_half = groundOf(half);
  std::size_t differ = 0;
  for (std::size_t k = 0; k < index.size(); ++k) {
    differ += of_half.is_ground[k] != of_whole.is_ground[index[k]] ? 1 : 0;
  }
  // Patches cut by the edge fit their planes to half of their points.
  EXPECT_LT(static_cast<double>(differ), 0.01 * static_cast<double>(index.size()));
}

}  // namespace
}  // namespace segdf

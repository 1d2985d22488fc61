// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/visibility_image.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

constexpr double kPi = 3.14159265358979323846;

VisibilityImage imageOf(const Scan& scan, const DynamicConfig& config = {}) {
  return {scan.points, std::vector<PointRole>(scan.points.size(), PointRole::kObject), config};
}

VolumetricState stateIn(const VisibilityImage& image, const Eigen::Vector3f& place) {
  VolumetricState state{};
  image.look(Eigen::MatrixX3f(place.transpose()), Eigen::Isometry3f::Identity(), &state);
  return state;
}

/// A wall 4 m high across the x axis, 20 m ahead, and nothing else but the ground.
Scan wallAhead() {
  test::BoxWorld world;
  world.add(20.5, 0.0, 1.0, 30.0, 4.0);
  return world.scan(0.0, 0.0, 0.0, 1);
}

TEST(VisibilityImage, APlaceIsFreeBeforeAWallHitAtItAndOccludedBehind) {
  const VisibilityImage image = imageOf(wallAhead());
  // The sensor is 1.73 m above the ground: 1 m above it is z = -0.73.
  EXPECT_EQ(stateIn(image, {10.0F, 0.0F, -0.73F}), VolumetricState::kFree);
  EXPECT_EQ(stateIn(image, {20.0F, 1.0F, -0.5F}), VolumetricState::kHit);
  EXPECT_EQ(stateIn(image, {30.0F, 0.0F, -0.73F}), VolumetricState::kOccluded);
}

TEST(VisibilityImage, WhereNoRayReturnedNothingIsKnown) {
  const VisibilityImage image = imageOf(wallAhead());
  EXPECT_EQ(stateIn(image, {-30.0F, 0.0F, 1.0F}), VolumetricState::kUnknown) << "open sky behind";
  EXPECT_EQ(stateIn(image, {0.5F, 0.0F, -0.5F}), VolumetricState::kUnknown) << "at the sensor";
  EXPECT_EQ(stateIn(image, {80.0F, 0.0F, 0.0F}), VolumetricState::kUnknown) << "too far";
  EXPECT_EQ(stateIn(image, {5.0F, 0.0F, 5.0F}), VolumetricState::kUnknown) << "above the lasers";
  const VisibilityImage nothing = imageOf(Scan{});
  EXPECT_EQ(stateIn(nothing, {10.0F, 0.0F, 0.0F}), VolumetricState::kUnknown);
}

// A black car 50 m away returns nothing; the rays over its roof end on the wall behind it.
TEST(VisibilityImage, RaysOverADarkThingDoNotSeeThroughIt) {
  test::BoxWorld world;
  world.add(57.5, 0.0, 1.0, 60.0, 6.0);
  const Scan wall = world.scan(0.0, 0.0, 0.0, 1);
  Scan dark = wall;
  const auto elevation = [](const Point& p) { return std::atan2(p.z, std::hypot(p.x, p.y)); };
  constexpr float kRoof = -0.005F;  // rad: the lasers are 0.007 rad apart up there
  dark.points.erase(std::remove_if(dark.points.begin(), dark.points.end(),
                                   [&](const Point& p) {
                                     return p.x > 0.0F && std::abs(p.y) < 0.1F * p.x &&
                                            elevation(p) < kRoof;
                                   }),
                    dark.points.end());
  float lowest = 1.0F;
  for (const Point& p : dark.points) {
    if (p.x > 0.0F && std::abs(p.y) < 0.1F * p.x) lowest = std::min(lowest, elevation(p));
  }
  // In the row of the lowest rays that pass, below them by more than the margin of 0.15 m at 50 m.
  for (float below : {0.004F, 0.006F, 0.008F}) {
    const Eigen::Vector3f place(50.0F, 0.0F, 50.0F * (lowest - below));
    EXPECT_EQ(stateIn(imageOf(wall), place), VolumetricState::kFree) << below;
    EXPECT_EQ(stateIn(imageOf(dark), place), VolumetricState::kUnknown) << below;
  }
  const Eigen::Vector3f over_the_roof(50.0F, 0.0F, 50.0F * (lowest + 0.001F));
  EXPECT_EQ(stateIn(imageOf(dark), over_the_roof), VolumetricState::kFree);
}

TEST(VisibilityImage, NothingOfAScanIsFreeInItsOwnImage) {
  test::BoxWorld world = test::makeStreet();
  world.add(8.0, 3.0, 4.2, 1.8, 1.5);
  const Scan scan = world.scan(0.0, 0.0, 0.0, 1);
  const VisibilityImage image = imageOf(scan);
  for (const Point& p : scan.points) {
    const float range = p.position().norm();
    if (range < 1.5F || range > 59.0F) continue;
    ASSERT_EQ(stateIn(image, p.position()), VolumetricState::kHit) << p.position().transpose();
  }
}

TEST(VisibilityImage, TheToleranceGrowsWithTheRange) {
  DynamicConfig config;
  config.tau = 0.05;
  config.tau_ratio = 0.02;
  const VisibilityImage image = imageOf(wallAhead(), config);
  // 2 % of 20 m is 0.4 m.
  EXPECT_EQ(stateIn(image, {19.7F, 0.0F, 0.0F}), VolumetricState::kHit);
  EXPECT_EQ(stateIn(image, {19.4F, 0.0F, 0.0F}), VolumetricState::kFree);
}

TEST(VisibilityImage, AnAnswerDoesNotDependOnWhereTheAzimuthBegins) {
  test::BoxWorld world = test::makeStreet();
  const Scan scan = world.scan(0.0, 0.0, 0.0, 1);
  std::size_t compared = 0;
  std::size_t different = 0;
  const VisibilityImage image = imageOf(scan);
  const Eigen::AngleAxisf turn(static_cast<float>(kPi), Eigen::Vector3f::UnitZ());
  Scan turned = scan;
  for (Point& p : turned.points) {
    const Eigen::Vector3f x = turn * p.position();
    p.x = x.x();
    p.y = x.y();
  }
  const VisibilityImage turned_image = imageOf(turned);
  for (const Point& p : scan.points) {
    const Eigen::Vector3f nearer = 0.7F * p.position();
    ++compared;
    different += stateIn(image, nearer) != stateIn(turned_image, turn * nearer) ? 1 : 0;
  }
  // Points on the border of two bins may change sides by rounding.
  EXPECT_LT(static_cast<double>(different), 0.01 * static_cast<double>(compared));
}

}  // namespace
}  // namespace segdf

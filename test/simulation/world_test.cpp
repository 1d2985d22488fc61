// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/world.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace segdf {
namespace {

/// Flat ground and one object.
Scene sceneWith(SceneObject object) {
  Scene scene;
  scene.ground.undulation = 0.0;
  scene.ground.kerb = 0.0;
  scene.objects.push_back(std::move(object));
  scene.ego = {{0.0, 0.0, 0.0, 0.0, 0.0}};
  return scene;
}

SceneObject boxObject(std::vector<WayPoint> path) {
  SceneObject object;
  Solid solid;
  solid.center = {0.0, 0.0, 1.0};
  solid.size = {2.0, 4.0, 2.0};
  solid.reflectance = 0.7F;
  object.solids = {solid};
  object.path = std::move(path);
  object.standing_class = 10;
  object.moving_class = 252;
  object.instance = 5;
  return object;
}

TEST(World, RangesAreThoseOfGeometry) {
  const World world(sceneWith(boxObject({{0.0, 10.0, 0.0, 0.0, 0.0}})));
  const auto front = world.cast({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 80.0);
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->range, 9.0, 1e-4);
  EXPECT_NEAR(front->cos_incidence, 1.0, 1e-5);
  EXPECT_EQ(front->material.label, (5U << 16U) | 10U);
  const double s = std::sqrt(0.5);
  const auto down = world.cast({0.0, 0.0, 1.0}, {0.0, s, -s}, 80.0);
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->range, std::sqrt(2.0), 1e-4);
  EXPECT_NEAR(down->cos_incidence, s, 1e-5);
  EXPECT_EQ(down->material.label, 40U);
  EXPECT_FALSE(world.cast({0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}, 80.0));
  EXPECT_FALSE(world.cast({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 8.9)) << "beyond the reach";
}

TEST(World, AMoverIsWhereItsPathSays) {
  World world(sceneWith(boxObject({{0.0, 10.0, 0.0, 0.0, 0.0}, {2.0, 30.0, 0.0, 0.0, 20.0}})));
  for (const auto& [time, range] : {std::pair{0.0, 9.0}, {1.0, 19.0}, {2.0, 29.0}, {9.0, 29.0}}) {
    world.moveTo(time);
    const auto hit = world.cast({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 80.0);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->range, range, 1e-4) << "at " << time << " s";
    EXPECT_EQ(hit->material.label, (5U << 16U) | 252U) << "it moves at some time, so it is a mover";
  }
}

TEST(World, ATurnedMoverShowsItsSide) {
  World world(
      sceneWith(boxObject({{0.0, 10.0, 0.0, 1.5707963, 0.0}, {2.0, 10.0, 5.0, 1.5707963, 5.0}})));
  const auto hit = world.cast({0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 80.0);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range, 8.0, 1e-3);
  EXPECT_NEAR(hit->cos_incidence, 1.0, 1e-4);
}

}  // namespace
}  // namespace segdf

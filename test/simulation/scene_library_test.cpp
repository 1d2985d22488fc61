// SPDX-License-Identifier: BSD-3-Clause
// The built-in scenes: they exist, they are plausible, and they hold what they are named for.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/simulation/ground_rectangle.hpp"
#include "segdf/simulation/scene_builder.hpp"
#include "segdf/simulation/scene_yaml.hpp"
#include "segdf/simulation/simulator.hpp"

namespace segdf {
namespace {

struct Seeded {
  std::string scene;
  std::uint64_t seed;
};

std::ostream& operator<<(std::ostream& out, const Seeded& seeded) {
  return out << seeded.scene << ", seed " << seeded.seed;
}

std::vector<Seeded> allScenes() {
  std::vector<Seeded> result;
  for (const std::string& name : sceneNames()) {
    for (std::uint64_t seed : {1, 101}) result.push_back({name, seed});
  }
  return result;
}

class BuiltIn : public ::testing::TestWithParam<Seeded> {
 protected:
  BuiltIn()
      : description_(loadScene(GetParam().scene)),
        scene_(buildScene(description_, GetParam().seed, description_.duration)) {}

  static GroundRectangle footprintAt(const SceneObject& object, double time) {
    const WayPoint at = object.at(time);
    return {{at.x, at.y, at.yaw}, object.length, object.width};
  }

  /// Everything that is on wheels or feet at a time, the ego first.
  std::vector<GroundRectangle> usersAt(double time) const {
    const WayPoint ego = interpolate(scene_.ego, time);
    std::vector<GroundRectangle> result{{{ego.x, ego.y, ego.yaw}, kEgoLength, kEgoWidth}};
    for (const SceneObject& object : scene_.objects) {
      if (object.moves()) result.push_back(footprintAt(object, time));
    }
    return result;
  }

  SceneDescription description_;
  Scene scene_;
};

TEST_P(BuiltIn, NobodyDrivesThroughAnything) {
  TakenGround standing;
  for (const SceneObject& object : scene_.objects) {
    if (!object.moves()) standing.add(footprintAt(object, 0.0));
  }
  for (double time = 0.0; time <= description_.duration; time += 0.3) {
    const std::vector<GroundRectangle> users = usersAt(time);
    for (std::size_t i = 0; i < users.size(); ++i) {
      ASSERT_TRUE(standing.isFree(users[i], 0.0))
          << "mover " << i << " in something that stands at " << time << " s, x "
          << users[i].place.x << " y " << users[i].place.y;
      for (std::size_t j = i + 1; j < users.size(); ++j) {
        ASSERT_FALSE(overlap(users[i], users[j]))
            << "movers " << i << " and " << j << " in each other at " << time << " s, x "
            << users[i].place.x << " y " << users[i].place.y;
      }
    }
  }
}

TEST_P(BuiltIn, SpeedsAreThoseOfBodies) {
  for (const SceneObject& object : scene_.objects) {
    for (std::size_t k = 2; k < object.path.size(); ++k) {
      const double before = (object.path[k - 1].way - object.path[k - 2].way) / 0.1;
      const double now = (object.path[k].way - object.path[k - 1].way) / 0.1;
      // Setting out takes 1.8 m/s^2 and no more; nobody goes backwards or faster than 15 m/s.
      ASSERT_LT(now - before, 0.19) << object.label();
      ASSERT_GE(now, 0.0);
      ASSERT_LT(now, 15.0);
    }
  }
}

TEST_P(BuiltIn, WhatCanMoveHasAnIdentityOfItsOwn) {
  std::set<std::uint16_t> instances;
  for (const SceneObject& object : scene_.objects) {
    const auto semantic_class = semantic_kitti::classOf(object.label());
    const bool movable =
        semantic_kitti::isMoving(semantic_class) || semantic_kitti::isParkedMovable(semantic_class);
    ASSERT_EQ(movable, object.instance != 0) << object.label();
    ASSERT_EQ(object.moves(), semantic_kitti::isMoving(semantic_class)) << object.label();
    if (movable) {
      ASSERT_TRUE(instances.insert(object.instance).second);
    }
  }
}

std::string nameOf(const ::testing::TestParamInfo<Seeded>& info) {
  return info.param.scene + "_" + std::to_string(info.param.seed);
}

// A fifth: even of a VLP-16's pulses, half of which go up, more come back on any street.
TEST_P(BuiltIn, EverySensorSeesIt) {
  for (const char* sensor : {"hdl64", "hdl32", "vlp16", "os1_64"}) {
    SimulationConfig config;
    config.sensor = sensor;
    config.seed = GetParam().seed;
    Simulator simulator(config, scene_, 1);
    const std::optional<SimulatedScan> scan = simulator.next();
    ASSERT_TRUE(scan) << sensor;
    const SensorModel& model = simulator.sensor();
    EXPECT_GT(scan->scan.points.size(), model.elevations.size() * model.columns / 5) << sensor;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltIn, ::testing::ValuesIn(allScenes()), nameOf);

TEST(SceneLibrary, HoldsAllOfThem) {
  const std::vector<std::string> names = sceneNames();
  ASSERT_EQ(names.size(), 23U);
  EXPECT_EQ(names.front(), "mixed");
  for (std::size_t k = 1; k < names.size(); ++k) {
    const std::string number = (k < 10 ? "0" : "") + std::to_string(k);
    EXPECT_EQ(names[k].substr(0, 4), "s" + number + "_");
    EXPECT_EQ(sceneSummary(names[k]).substr(0, 3), "S" + std::to_string(k) + (k < 10 ? ":" : ""));
  }
}

TEST(SceneLibrary, OtherSeedsMakeOtherStreetsAndTheSameSeedTheSame) {
  const SceneDescription description = loadScene("s01_empty_street");
  const Scene once = buildScene(description, 5, 2.0);
  const Scene again = buildScene(description, 5, 2.0);
  const Scene other = buildScene(description, 6, 2.0);
  ASSERT_EQ(once.objects.size(), again.objects.size());
  for (std::size_t k = 0; k < once.objects.size(); ++k) {
    EXPECT_EQ(once.objects[k].path[0].x, again.objects[k].path[0].x);
    EXPECT_EQ(once.objects[k].solids.size(), again.objects[k].solids.size());
  }
  EXPECT_NE(once.objects[0].path[0].x, other.objects[0].path[0].x);
}

/// What the descriptions promise in figures.
TEST(SceneLibrary, ScenesHoldWhatTheyAreNamedFor) {
  const auto speeds = [](const std::string& name) {
    const SceneDescription description = loadScene(name);
    const Scene scene = buildScene(description, 1, description.duration);
    std::vector<double> result;
    for (const SceneObject& object : scene.objects) {
      if (object.moves()) result.push_back(object.path.back().way / description.duration);
    }
    return result;
  };
  EXPECT_TRUE(speeds("s01_empty_street").empty());
  EXPECT_TRUE(speeds("s02_parked_rows").empty());
  for (double speed : speeds("s04_convoy")) EXPECT_NEAR(speed, 8.0, 0.1);
  const std::vector<double> creeping = speeds("s07_creeping");
  ASSERT_EQ(creeping.size(), 2U);
  EXPECT_NEAR(creeping[0], 1.0, 0.02);
  EXPECT_NEAR(creeping[1], 0.4, 0.02);

  const SceneDescription follow = loadScene("s21_constant_follow");
  const Scene scene = buildScene(follow, 1, follow.duration);
  const auto ahead = std::find_if(scene.objects.begin(), scene.objects.end(),
                                  [](const SceneObject& object) { return object.moves(); });
  ASSERT_NE(ahead, scene.objects.end());
  for (double time = 0.0; time < follow.duration; time += 0.5) {
    const double gap =
        ahead->at(time).x - interpolate(scene.ego, time).x - (ahead->length + kEgoLength) / 2.0;
    EXPECT_NEAR(gap, 10.0, 0.6) << "its length is drawn: 3.7 to 4.8 m";
  }
}

TEST(SceneLibrary, TheMixedDriveIsOneOf300Metres) {
  const SceneDescription description = loadScene("mixed");
  const Scene scene = buildScene(description, 1, description.duration);
  EXPECT_GT(scene.ego.back().way, 300.0);
  double standing = 0.0;
  double climbed = 0.0;
  for (std::size_t k = 1; k < scene.ego.size(); ++k) {
    const WayPoint& a = scene.ego[k - 1];
    const WayPoint& b = scene.ego[k];
    if (b.way - a.way < 1e-3 && b.way < 170.0) standing += b.time - a.time;
    climbed += std::max(0.0, scene.ground.heightAt(b.x, b.y) - scene.ground.heightAt(a.x, a.y));
  }
  EXPECT_GT(standing, 3.0) << "it stops at the lights";
  EXPECT_GT(climbed, 4.0) << "60 m of 4 % and 20 m of 8 %";
  EXPECT_NEAR(scene.ego.back().yaw - scene.ego.front().yaw, 1.047, 0.02) << "60 degrees";
}

}  // namespace
}  // namespace segdf

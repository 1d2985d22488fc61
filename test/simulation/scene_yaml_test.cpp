// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/scene_yaml.hpp"

#include <ostream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(SceneYaml, SaysWhatItSays) {
  const SceneDescription scene = parseScene(R"(
duration: 20
sensor: vlp16
dropout: [0, 0.1]
poses: {noise: 0.1, angle: 0.2, drift: 0.5}
street:
  length: 150
  bends: [{at: 50, angle: 90, radius: 30}]
  grades: [{from: 10, to: 40, percent: 4}]
  lights: [{at: 100, red: [5, 9, 20, 24]}]
  parked_gap: 0.5
ego: {speed: 6, halts: [{at: 20, for: 3}]}
movers:
  - {kind: bus, path: [[0, 1.75], [-50, 1.75]], speed: 7, start: 2}
flows:
  - {kind: [car, van], lane: 1.75, forward: false, speed: 7, gap: [20, 40]}
things:
  - {kind: wall, at: [30, 9], length: 20, heading: 90}
)",
                                            "x.yaml");
  EXPECT_EQ(scene.duration, 20.0);
  EXPECT_EQ(scene.sensor, "vlp16");
  EXPECT_EQ(scene.dropout.high, 0.1);
  EXPECT_EQ(scene.pose_drift, 0.5);
  EXPECT_NEAR(scene.street.bends.at(0).angle, 1.5707963, 1e-6);
  EXPECT_EQ(scene.street.grades.at(0).percent, 4.0);
  EXPECT_EQ(scene.street.lights.at(0).red.at(1).second, 24.0);
  EXPECT_EQ(scene.street.parked_gap.low, 0.5);
  EXPECT_EQ(scene.street.parked_gap.high, 0.5);
  EXPECT_EQ(scene.ego.halts.at(0).duration, 3.0);
  EXPECT_EQ(scene.movers.at(0).kind, ObjectKind::kBus);
  EXPECT_EQ(scene.movers.at(0).path.at(1).along, -50.0);
  EXPECT_FALSE(scene.flows.at(0).forward);
  EXPECT_EQ(scene.flows.at(0).kinds.size(), 2U);
  EXPECT_NEAR(scene.things.at(0).heading, 1.5707963, 1e-6);
  EXPECT_EQ(scene.things.at(0).size.length, 20.0);
}

struct BadScene {
  const char* yaml;
  const char* message;
};

std::ostream& operator<<(std::ostream& out, const BadScene& scene) { return out << scene.message; }

class BadSceneYaml : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadSceneYaml, GetsOneClearLine) {
  try {
    parseScene(GetParam().yaml, "x.yaml");
    FAIL() << "taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), std::string("x.yaml: ") + GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    BadSceneYaml,
    ::testing::Values(
        BadScene{"", "has no 'duration'"},
        BadScene{"[1, 2]", "a scene must hold keys, 'name: value'"},
        BadScene{"duration: 5\nego: fast", "ego must hold keys, 'name: value'"},
        BadScene{"duration: soon", "duration = soon must be a number"},
        BadScene{"duration: 0", "duration = 0 must be from 0.1 to 3600"},
        BadScene{"duration: .nan", "duration = .nan must be from 0.1 to 3600"},
        BadScene{"duration: 5\nego: {sped: 3}",
                 "unknown key 'ego.sped'; known are: path, speed, start, halts"},
        BadScene{"duration: 5\nmovers: [{kind: car, speed: 3}]", "movers[0] has no 'path'"},
        BadScene{
            "duration: 5\nmovers: [{kind: tram, path: [[0, 0]], speed: 3}]",
            "movers[0].kind = tram must be one of car, van, bus, truck, person, cyclist, tree, "
            "bush, pole, sign, bollard, hedge, fence, wall, house"},
        BadScene{"duration: 5\nmovers: [{kind: tree, path: [[0, 0]], speed: 3}]",
                 "only car, van, bus, truck, person and cyclist can move, not movers[0]"},
        BadScene{"duration: 5\nmovers: [{kind: car, path: [[0]], speed: 3}]",
                 "movers[0].path = (not a single value) must be [along, across] in metres"},
        BadScene{"duration: 5\nmovers: {kind: car}",
                 "movers = (not a single value) must be a list"},
        BadScene{"duration: 5\ndropout: [0.2, 0.1]",
                 "dropout = [0.2, 0.1] must be in order, low before high"},
        BadScene{"duration: 5\nstreet: {lights: [{at: 5, red: [1, 2, 3]}]}",
                 "street.lights[0].red must hold pairs: from, to, from, to, ... seconds"},
        BadScene{"duration: 5\nstreet: {bends: [{at: 50, angle: 90}, {at: 60, angle: 20}]}",
                 "the bend at 60 m begins before the one in front of it ends"},
        BadScene{"duration: 5\n  ego: {", "line 2 is no YAML: illegal map value"}));

TEST(SceneYaml, AnUnknownSceneIsNamed) {
  EXPECT_THROW(loadScene("s99_nowhere"), std::invalid_argument);
  EXPECT_THROW(sceneSummary("s99_nowhere"), std::invalid_argument);
}

}  // namespace
}  // namespace segdf

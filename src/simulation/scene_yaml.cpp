// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/scene_yaml.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "segdf/simulation/scene_files.hpp"

#include "yaml_map.hpp"

namespace segdf {

namespace {

using detail::YamlMap;

constexpr double kRadians = 3.14159265358979323846 / 180.0;
constexpr double kFar = 10000.0;  // metres
constexpr double kLong = 3600.0;  // seconds

void readBends(YamlMap& street, std::vector<Bend>& bends) {
  for (YamlMap& entry : street.maps("bends")) {
    Bend bend;
    double degrees = 0.0;
    for (const char* key : {"at", "angle"}) entry.require(key);
    entry.number("at", bend.at, 0.0, kFar);
    entry.number("angle", degrees, -180.0, 180.0);
    entry.number("radius", bend.radius, 20.0, 1000.0);
    entry.finish();
    bend.angle = degrees * kRadians;
    bends.push_back(bend);
  }
}

void readGrades(YamlMap& street, std::vector<Grade>& grades) {
  for (YamlMap& entry : street.maps("grades")) {
    Grade grade;
    for (const char* key : {"from", "to", "percent"}) entry.require(key);
    entry.number("from", grade.from, -kFar, kFar);
    entry.number("to", grade.to, grade.from, kFar);
    entry.number("percent", grade.percent, -15.0, 15.0);
    entry.finish();
    grades.push_back(grade);
  }
}

void readLights(YamlMap& street, std::vector<Light>& lights) {
  for (YamlMap& entry : street.maps("lights")) {
    Light light;
    std::vector<double> red;
    for (const char* key : {"at", "red"}) entry.require(key);
    entry.number("at", light.at, -kFar, kFar);
    entry.numbers("red", red, 0.0, kLong);
    if (red.size() % 2 != 0) {
      entry.fail(entry.prefix() + ".red must hold pairs: from, to, from, to, ... seconds");
    }
    for (std::size_t k = 0; k < red.size(); k += 2) light.red.emplace_back(red[k], red[k + 1]);
    entry.finish();
    lights.push_back(light);
  }
}

void readStreet(YamlMap map, StreetDescription& street) {
  map.number("length", street.length, 1.0, kFar);
  readBends(map, street.bends);
  readGrades(map, street.grades);
  map.number("undulation", street.undulation, 0.0, 2.0);
  map.number("kerb", street.kerb, 0.0, 0.5);
  map.numbers("junctions", street.junctions, -kFar, kFar);
  readLights(map, street.lights);
  map.number("houses", street.houses, 0.0, 1.0);
  constexpr double kDense = 100.0;  // per 100 m
  map.number("trees", street.trees, 0.0, kDense);
  map.number("bushes", street.bushes, 0.0, kDense);
  map.number("poles", street.poles, 0.0, kDense);
  map.number("signs", street.signs, 0.0, kDense);
  map.number("bollards", street.bollards, 0.0, kDense);
  map.number("hedges", street.hedges, 0.0, kDense);
  map.number("fences", street.fences, 0.0, kDense);
  map.number("people", street.people, 0.0, kDense);
  map.number("parked", street.parked, 0.0, 1.0);
  map.bounds("parked_gap", street.parked_gap, 0.2, 100.0);
  map.finish();
}

std::vector<Halt> readHalts(YamlMap& map) {
  std::vector<Halt> halts;
  for (YamlMap& entry : map.maps("halts")) {
    Halt halt;
    for (const char* key : {"at", "for"}) entry.require(key);
    entry.number("at", halt.at, halts.empty() ? 0.0 : halts.back().at, kFar);
    entry.number("for", halt.duration, 0.0, kLong);
    entry.finish();
    halts.push_back(halt);
  }
  return halts;
}

void readEgo(YamlMap map, EgoDescription& ego) {
  map.points("path", ego.path);
  map.number("speed", ego.speed, 0.1, 50.0);
  map.number("start", ego.start, 0.0, kLong);
  ego.halts = readHalts(map);
  map.finish();
}

void requireMovable(const YamlMap& map, ObjectKind kind) {
  if (canMove(kind)) return;
  map.fail("only car, van, bus, truck, person and cyclist can move, not " + map.prefix());
}

MoverDescription readMover(YamlMap& map) {
  MoverDescription mover;
  for (const char* key : {"kind", "path", "speed"}) map.require(key);
  map.kind("kind", mover.kind);
  requireMovable(map, mover.kind);
  map.points("path", mover.path);
  map.number("speed", mover.speed, 0.05, 50.0);
  map.number("start", mover.start, 0.0, kLong);
  mover.halts = readHalts(map);
  map.flag("lights", mover.lights);
  map.finish();
  return mover;
}

FlowDescription readFlow(YamlMap& map) {
  FlowDescription flow;
  for (const char* key : {"kind", "lane", "forward", "speed", "gap"}) map.require(key);
  map.kinds("kind", flow.kinds);
  for (ObjectKind kind : flow.kinds) requireMovable(map, kind);
  map.number("lane", flow.lane, -100.0, 100.0);
  map.flag("forward", flow.forward);
  map.bounds("speed", flow.speed, 0.05, 50.0);
  map.bounds("gap", flow.gap, 1.0, 1000.0);
  map.flag("lights", flow.lights);
  map.finish();
  return flow;
}

ThingDescription readThing(YamlMap& map) {
  ThingDescription thing;
  double degrees = 0.0;
  for (const char* key : {"kind", "at"}) map.require(key);
  map.kind("kind", thing.kind);
  map.point("at", thing.at);
  map.number("heading", degrees, -360.0, 360.0);
  map.number("length", thing.size.length, 0.2, 500.0);
  map.number("depth", thing.size.depth, 0.2, 100.0);
  map.number("height", thing.size.height, 0.2, 50.0);
  map.finish();
  thing.heading = degrees * kRadians;
  return thing;
}

void readDisturbances(YamlMap& root, SceneDescription& scene) {
  YamlMap poses = root.map("poses");
  poses.number("noise", scene.pose_noise, 0.0, 10.0);
  poses.number("angle", scene.pose_noise_angle, 0.0, 45.0);
  poses.number("drift", scene.pose_drift, 0.0, 20.0);
  poses.finish();
  root.text("sensor", scene.sensor);
  root.bounds("dropout", scene.dropout, 0.0, 1.0);
}

YAML::Node load(const std::string& yaml, const std::string& where) {
  try {
    return YAML::Load(yaml);
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(where + ": line " + std::to_string(error.mark.line + 1) +
                                " is no YAML: " + error.msg);
  }
}

std::string readFile(const std::string& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::invalid_argument("cannot read scene " + file + "; check the path");
  return text.str();
}

}  // namespace

SceneDescription parseScene(const std::string& yaml, const std::string& where) {
  YamlMap root(load(yaml, where), where, "");
  SceneDescription scene;
  root.require("duration");
  root.number("duration", scene.duration, 0.1, kLong);
  readDisturbances(root, scene);
  readStreet(root.map("street"), scene.street);
  readEgo(root.map("ego"), scene.ego);
  for (YamlMap& entry : root.maps("movers")) scene.movers.push_back(readMover(entry));
  for (YamlMap& entry : root.maps("flows")) scene.flows.push_back(readFlow(entry));
  for (YamlMap& entry : root.maps("things")) scene.things.push_back(readThing(entry));
  root.finish();
  try {
    const CentreLine line(scene.street.bends);
  } catch (const std::invalid_argument& error) {
    root.fail(error.what());
  }
  return scene;
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& [name, text] : sceneFiles()) names.push_back(name);
  return names;
}

std::string sceneSummary(const std::string& name) {
  const auto file = sceneFiles().find(name);
  if (file == sceneFiles().end()) throw std::invalid_argument("no scene '" + name + "'");
  const std::string& text = file->second;
  const std::size_t begin = text.find_first_not_of("# \n");
  return text.substr(begin, text.find('\n', begin) - begin);
}

SceneDescription loadScene(const std::string& name_or_file) {
  const auto file = sceneFiles().find(name_or_file);
  if (file != sceneFiles().end()) {
    return parseScene(file->second, "cfg/scenes/" + file->first + ".yaml");
  }
  if (std::filesystem::is_regular_file(name_or_file)) {
    return parseScene(readFile(name_or_file), name_or_file);
  }
  throw std::invalid_argument("scene '" + name_or_file +
                              "' is neither built in (see --list-scenes) nor a file");
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "yaml_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace segdf::detail {

namespace {

constexpr double kFarthest = 10000.0;  // metres along or across

const std::array<std::pair<const char*, ObjectKind>, 15> kKinds{{
    {"car", ObjectKind::kCar},
    {"van", ObjectKind::kVan},
    {"bus", ObjectKind::kBus},
    {"truck", ObjectKind::kTruck},
    {"person", ObjectKind::kPerson},
    {"cyclist", ObjectKind::kCyclist},
    {"tree", ObjectKind::kTree},
    {"bush", ObjectKind::kBush},
    {"pole", ObjectKind::kPole},
    {"sign", ObjectKind::kSign},
    {"bollard", ObjectKind::kBollard},
    {"hedge", ObjectKind::kHedge},
    {"fence", ObjectKind::kFence},
    {"wall", ObjectKind::kWall},
    {"house", ObjectKind::kHouse},
}};

std::string plain(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

}  // namespace

YamlMap::YamlMap(const YAML::Node& node, std::string where, std::string prefix)
    : node_(node), where_(std::move(where)), prefix_(std::move(prefix)) {
  if (node_.IsDefined() && !node_.IsNull() && !node_.IsMap()) {
    throw std::invalid_argument(where_ + ": " + (prefix_.empty() ? "a scene" : prefix_) +
                                " must hold keys, 'name: value'");
  }
}

void YamlMap::fail(const std::string& message) const {
  throw std::invalid_argument(where_ + ": " + message);
}

YAML::Node YamlMap::find(const std::string& key) {
  if (std::find(keys_.begin(), keys_.end(), key) == keys_.end()) keys_.push_back(key);
  if (!node_.IsDefined() || node_.IsNull()) return YAML::Node(YAML::NodeType::Undefined);
  return node_[key];
}

bool YamlMap::has(const std::string& key) { return find(key).IsDefined(); }

void YamlMap::require(const std::string& key) {
  if (!has(key)) fail((prefix_.empty() ? "" : prefix_ + " ") + "has no '" + key + "'");
}

void YamlMap::wrong(const std::string& key,
                    const YAML::Node& node,
                    const std::string& wanted) const {
  const std::string value = node.IsScalar() ? node.Scalar() : "(not a single value)";
  fail((prefix_.empty() ? "" : prefix_ + ".") + key + " = " + value + " must be " + wanted);
}

double YamlMap::toNumber(const std::string& key,
                         const YAML::Node& node,
                         double min,
                         double max) const {
  double value = 0.0;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
    wrong(key, node, "a number");
  }
  // Not "value < min || ...": NaN is out of bounds as well.
  if (!(value >= min && value <= max)) {
    wrong(key, node, "from " + plain(min) + " to " + plain(max));
  }
  return value;
}

StreetPoint YamlMap::toPoint(const std::string& key, const YAML::Node& node) const {
  if (!node.IsSequence() || node.size() != 2) wrong(key, node, "[along, across] in metres");
  return {toNumber(key, node[0], -kFarthest, kFarthest),
          toNumber(key, node[1], -kFarthest, kFarthest)};
}

ObjectKind YamlMap::toKind(const std::string& key, const YAML::Node& node) const {
  std::vector<std::string> known;
  for (const auto& [name, kind] : kKinds) {
    if (node.IsScalar() && node.Scalar() == name) return kind;
    known.emplace_back(name);
  }
  wrong(key, node, "one of " + listed(known));
}

void YamlMap::number(const std::string& key, double& value, double min, double max) {
  if (has(key)) value = toNumber(key, find(key), min, max);
}

void YamlMap::numbers(const std::string& key, std::vector<double>& values, double min, double max) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence()) wrong(key, node, "a list of numbers");
  values.clear();
  for (const YAML::Node& entry : node) values.push_back(toNumber(key, entry, min, max));
}

void YamlMap::bounds(const std::string& key, Bounds& value, double min, double max) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (node.IsScalar()) {
    value.low = value.high = toNumber(key, node, min, max);
    return;
  }
  if (!node.IsSequence() || node.size() != 2) wrong(key, node, "a number or [low, high]");
  value = {toNumber(key, node[0], min, max), toNumber(key, node[1], min, max)};
  if (value.low > value.high) {
    fail((prefix_.empty() ? "" : prefix_ + ".") + key + " = [" + plain(value.low) + ", " +
         plain(value.high) + "] must be in order, low before high");
  }
}

void YamlMap::flag(const std::string& key, bool& value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  try {
    value = node.as<bool>();
  } catch (const YAML::Exception&) {
    wrong(key, node, "true or false");
  }
}

void YamlMap::text(const std::string& key, std::string& value) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar()) wrong(key, node, "a name");
  value = node.Scalar();
}

void YamlMap::point(const std::string& key, StreetPoint& value) {
  if (has(key)) value = toPoint(key, find(key));
}

void YamlMap::points(const std::string& key, std::vector<StreetPoint>& values) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence() || node.size() == 0) wrong(key, node, "a list of [along, across]");
  values.clear();
  for (const YAML::Node& entry : node) values.push_back(toPoint(key, entry));
}

void YamlMap::kind(const std::string& key, ObjectKind& value) {
  if (has(key)) value = toKind(key, find(key));
}

void YamlMap::kinds(const std::string& key, std::vector<ObjectKind>& values) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  values.clear();
  if (node.IsSequence()) {
    for (const YAML::Node& entry : node) values.push_back(toKind(key, entry));
  } else {
    values.push_back(toKind(key, node));
  }
}

YamlMap YamlMap::map(const std::string& key) {
  return {find(key), where_, (prefix_.empty() ? "" : prefix_ + ".") + key};
}

std::vector<YamlMap> YamlMap::maps(const std::string& key) {
  const YAML::Node node = find(key);
  std::vector<YamlMap> result;
  if (!node.IsDefined() || node.IsNull()) return result;
  if (!node.IsSequence()) wrong(key, node, "a list");
  for (std::size_t k = 0; k < node.size(); ++k) {
    result.emplace_back(
        node[k], where_,
        (prefix_.empty() ? "" : prefix_ + ".") + key + "[" + std::to_string(k) + "]");
  }
  return result;
}

void YamlMap::finish() const {
  if (!node_.IsDefined() || node_.IsNull()) return;
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(a list or map)";
    if (std::find(keys_.begin(), keys_.end(), key) != keys_.end()) continue;
    fail("unknown key '" + (prefix_.empty() ? "" : prefix_ + ".") + key +
         "'; known are: " + listed(keys_));
  }
}

}  // namespace segdf::detail

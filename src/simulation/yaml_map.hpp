// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "segdf/simulation/scene_description.hpp"

namespace segdf::detail {

/// A map of a YAML document that is taken apart key by key and knows where it stands, so that every
/// complaint names file and key. What finish() has not seen asked for is unknown.
class YamlMap {
 public:
  /// @param where file, and path of the map in it
  /// @throws std::invalid_argument when the node is no map
  YamlMap(const YAML::Node& node, std::string where, std::string prefix);

  bool has(const std::string& key);
  /// Overwrites the value when the key is there. @throws std::invalid_argument
  void number(const std::string& key, double& value, double min, double max);
  void numbers(const std::string& key, std::vector<double>& values, double min, double max);
  /// One number, or a list of two in order.
  void bounds(const std::string& key, Bounds& value, double min, double max);
  void flag(const std::string& key, bool& value);
  void text(const std::string& key, std::string& value);
  /// [along, across], or a list of such places.
  void point(const std::string& key, StreetPoint& value);
  void points(const std::string& key, std::vector<StreetPoint>& values);
  void kind(const std::string& key, ObjectKind& value);
  /// One kind or a list.
  void kinds(const std::string& key, std::vector<ObjectKind>& values);
  /// A map under a key; an empty one when it is not there.
  YamlMap map(const std::string& key);
  /// The maps of a list; none when the key is not there.
  std::vector<YamlMap> maps(const std::string& key);

  /// @throws std::invalid_argument when the key is missing
  void require(const std::string& key);
  /// @throws std::invalid_argument naming the first unknown key and all known ones
  void finish() const;
  [[noreturn]] void fail(const std::string& message) const;
  /// Where the map stands in the file, e.g. "movers[2]"; empty for the whole of it.
  const std::string& prefix() const { return prefix_; }

 private:
  YAML::Node find(const std::string& key);
  double toNumber(const std::string& key, const YAML::Node& node, double min, double max) const;
  StreetPoint toPoint(const std::string& key, const YAML::Node& node) const;
  ObjectKind toKind(const std::string& key, const YAML::Node& node) const;
  [[noreturn]] void wrong(const std::string& key,
                          const YAML::Node& node,
                          const std::string& wanted) const;

  YAML::Node node_;
  std::string where_;
  std::string prefix_;
  std::vector<std::string> keys_;
};

}  // namespace segdf::detail

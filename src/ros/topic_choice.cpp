// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/topic_choice.hpp"

#include <vector>

#include <ros/master.h>

#include "segdf/io/scan_source.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

std::string withoutSlash(const std::string& topic) {
  return topic.rfind('/', 0) == 0 ? topic.substr(1) : topic;
}

TopicTypes::const_iterator find(const TopicTypes& topics, const std::string& name) {
  auto it = topics.begin();
  while (it != topics.end() && withoutSlash(it->first) != withoutSlash(name)) ++it;
  return it;
}

std::string listOf(const TopicTypes& topics) {
  std::string list;
  for (const auto& [name, type] : topics) {
    list.append(list.empty() ? "" : ", ").append(name).append(" (").append(type).append(")");
  }
  return list.empty() ? "none at all" : list;
}

std::string alternatives(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text.append(text.empty() ? "'" : " or '").append(name).append("'");
  }
  return text;
}

/// What is looked for.
struct Wanted {
  std::string kind;                ///< for messages
  std::vector<std::string> names;  ///< in order of preference
  std::string type;
};

std::string choose(const TopicTypes& topics, const Wanted& wanted, const std::string& where) {
  for (const std::string& name : wanted.names) {
    const auto found = find(topics, name);
    if (found == topics.end()) continue;
    if (found->second == wanted.type) return found->first;
    throw IoError(where + ": topic '" + found->first + "' is " + found->second + ", but the " +
                  wanted.kind + " topic must be " + wanted.type + "; topics: " + listOf(topics));
  }
  throw IoError(where + " has no topic " + alternatives(wanted.names) + "; name its " +
                wanted.kind + " topic, one of: " + listOf(topics));
}

std::vector<std::string> orDefault(const std::string& wanted, std::vector<std::string> defaults) {
  return wanted.empty() ? std::move(defaults) : std::vector<std::string>{wanted};
}

/// @throws IoError if none of `names` is there, but LIO-SAM's cloud of features is: named, it would
/// be refused as well, so it must not be offered
void refuseFeaturesAlone(const TopicTypes& topics,
                         const std::vector<std::string>& names,
                         const std::string& where) {
  for (const std::string& name : names) {
    if (find(topics, name) != topics.end()) return;
  }
  const auto features = find(topics, topics::kFeatureCloud);
  if (features == topics.end()) return;
  throw IoError(where + " has no topic " + alternatives(names) + "; its '" + features->first +
                "' holds only LIO-SAM's down-sampled corner and surface features, not the sweep: " +
                "record '" + topics::kRegisteredCloud + "' instead");
}

}  // namespace

TopicTypes topicsOnAir() {
  ros::master::V_TopicInfo published;
  ros::master::getTopics(published);
  TopicTypes topics;
  for (const ros::master::TopicInfo& topic : published) topics[topic.name] = topic.datatype;
  return topics;
}

std::string topicsOfType(const TopicTypes& topics, const std::string& type) {
  std::string names;
  for (const auto& [name, its_type] : topics) {
    if (its_type == type) names.append(names.empty() ? "" : ", ").append(name);
  }
  return names.empty() ? "no topic" : names;
}

std::string chooseCloudTopic(const TopicTypes& topics,
                             const std::string& wanted,
                             const std::string& where) {
  refuseFeatureCloud(wanted);
  const std::vector<std::string> names =
      orDefault(wanted, {topics::kRegisteredCloud, topics::kDeskewedCloud});
  if (wanted.empty()) refuseFeaturesAlone(topics, names, where);
  return choose(topics, {"cloud", names, topics::kCloudType}, where);
}

std::string chooseOdometryTopic(const TopicTypes& topics,
                                const std::string& wanted,
                                const std::string& where) {
  return choose(topics, {"odometry", orDefault(wanted, {topics::kOdometry}), topics::kOdometryType},
                where);
}

void refuseFeatureCloud(const std::string& topic) {
  if (withoutSlash(topic) != withoutSlash(topics::kFeatureCloud)) return;
  throw IoError(
      "topic '" + topic + "' holds LIO-SAM's down-sampled corner and surface features, not " +
      "the sweep: take '" + topics::kRegisteredCloud + "' or '" + topics::kDeskewedCloud + "'");
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace segdf {

/// Topics and their types, e.g. those of a bag.
using TopicTypes = std::map<std::string, std::string>;

/// The topics that the ROS master knows a publisher of; none when it does not answer.
TopicTypes topicsOnAir();

/// "/a, /b", or "no topic".
std::string topicsOfType(const TopicTypes& topics, const std::string& type);

/// The topic to take clouds from, as `topics` spells it.
/// @param wanted name with or without leading slash; empty: LIO-SAM's registered, else its deskewed
/// cloud
/// @param where begins the messages, e.g. "bag 'drive.bag'"
/// @throws IoError if the topic is missing, of another type, or LIO-SAM's cloud of features
std::string chooseCloudTopic(const TopicTypes& topics,
                             const std::string& wanted,
                             const std::string& where);

/// The topic to take poses from; as chooseCloudTopic(). Empty: LIO-SAM's.
std::string chooseOdometryTopic(const TopicTypes& topics,
                                const std::string& wanted,
                                const std::string& where);

/// @throws IoError if `topic` is LIO-SAM's cloud of features, which holds no sweep
void refuseFeatureCloud(const std::string& topic);

}  // namespace segdf

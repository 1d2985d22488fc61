// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <rosbag/bag.h>

#include "segdf/core/scan.hpp"
#include "segdf/ros/bag_source.hpp"
#include "segdf/ros/topic_choice.hpp"

namespace segdf {

/// What stands before the points of a cloud.
struct CloudRecord {
  std::int64_t stamp_ns = 0;     ///< header stamp
  std::int64_t received_ns = 0;  ///< when it was recorded
  std::size_t points = 0;
  std::string frame;
};

/// An odometry message.
struct PoseRecord {
  std::int64_t stamp_ns = 0;
  std::int64_t received_ns = 0;
  Pose pose = Pose::Identity();  ///< not finite if the message holds no rotation
  std::string frame;
  std::string child_frame;
};

/// A cloud and its pose, as indices into a survey's records.
struct RecordPair {
  std::size_t cloud = 0;
  std::size_t pose = 0;
};

/// What a bag says without looking at a point.
struct BagSurvey {
  TopicTypes types;
  std::map<std::string, std::size_t> messages;  ///< by topic
  BagTopics topics;                             ///< those that hold the drive
  std::vector<CloudRecord> clouds;              ///< in the order of the bag
  std::vector<PoseRecord> poses;                ///< in the order of the bag
  std::vector<RecordPair> pairs;  ///< clouds with the first pose of identical stamp, in their order
  std::string break_off;          ///< why the bag cannot be read to its end, empty if it can
};

/// The first half of findDrive(): the topic of the clouds.
std::string findCloudTopic(const TopicTypes& types,
                           const std::string& wanted,
                           const std::string& where);

/// Which topics hold the drive: as BagSource chooses them, but when a bag has none of LIO-SAM's and
/// just one of the type that is needed, that one.
/// @param where begins the messages. @throws IoError as chooseCloudTopic()
BagTopics findDrive(const TopicTypes& types, const BagTopics& wanted, const std::string& where);

/// The pairs whose clouds are later than all before them: what the pipeline takes.
std::vector<RecordPair> inOrder(const BagSurvey& survey);

/// "cloud 12 at 1.2 s", for messages; counted and timed from the first cloud.
std::string cloudAt(const BagSurvey& survey, std::size_t cloud);

/// Fills in topics and counts; reads the index only.
void surveyTopics(const rosbag::Bag& bag, BagSurvey& survey);

/// Fills in the rest: stamps, frames and poses; of the clouds no more than what stands before the
/// points. One pass. @pre surveyTopics() @throws IoError if the topics cannot be used
void surveyDrive(const rosbag::Bag& bag,
                 const BagTopics& wanted,
                 const std::string& where,
                 BagSurvey& survey);

}  // namespace segdf

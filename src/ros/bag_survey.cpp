// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_survey.hpp"

#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/bag_access.hpp"
#include "segdf/ros/bag_report.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {

/// A PointCloud2 up to its fields: rosbag takes it for the whole message, and copies no points.
struct CloudHead {
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
};

}  // namespace segdf

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<segdf::CloudHead> : MD5Sum<sensor_msgs::PointCloud2> {
  static const char* value(const segdf::CloudHead& /*head*/) {
    return MD5Sum<sensor_msgs::PointCloud2>::value();
  }
  using MD5Sum<sensor_msgs::PointCloud2>::value;
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<segdf::CloudHead> {
  template <class Stream>
  static void read(Stream& stream, segdf::CloudHead& head) {
    stream.next(head.header);
    stream.next(head.height);
    stream.next(head.width);
  }
};

}  // namespace serialization
}  // namespace ros

namespace segdf {
namespace {

std::int64_t receiptOf(const rosbag::MessageInstance& instance) {
  return static_cast<std::int64_t>(instance.getTime().toNSec());
}

CloudRecord cloudRecord(const rosbag::MessageInstance& instance) {
  const auto head = readMessage<CloudHead>(instance);
  return {stampOf(head->header), receiptOf(instance), std::size_t{head->width} * head->height,
          head->header.frame_id};
}

PoseRecord poseRecord(const rosbag::MessageInstance& instance) {
  const auto odometry = readMessage<nav_msgs::Odometry>(instance);
  return {stampOf(odometry->header), receiptOf(instance), toPose(odometry->pose.pose),
          odometry->header.frame_id, odometry->child_frame_id};
}

/// The one topic of that type that may hold the drive, "" if there is none or a choice.
std::string onlyTopic(const TopicTypes& types, const std::string& type) {
  std::string only;
  for (const auto& [topic, its_type] : types) {
    const bool own = topic == topics::kTruthLabels || topic == topics::kFeatureCloud;
    if (its_type != type || own) continue;
    if (!only.empty()) return "";
    only = topic;
  }
  return only;
}

/// What is wanted, or found under LIO-SAM's names, else the only topic of its type.
template <class Choose>
std::string chooseOrOnly(const TopicTypes& types,
                         const std::string& wanted,
                         const std::string& type,
                         const Choose& choose) {
  try {
    return choose(wanted);
  } catch (const IoError&) {
    std::string only = wanted.empty() ? onlyTopic(types, type) : "";
    if (only.empty()) throw;
    return only;
  }
}

void readRecords(const rosbag::Bag& bag, BagSurvey& survey) {
  rosbag::View view(bag,
                    rosbag::TopicQuery(std::vector{survey.topics.cloud, survey.topics.odometry}));
  for (const rosbag::MessageInstance& instance : view) {
    if (instance.getTopic() == survey.topics.cloud) {
      survey.clouds.push_back(cloudRecord(instance));
    } else {
      survey.poses.push_back(poseRecord(instance));
    }
  }
}

std::vector<RecordPair> pairUp(const BagSurvey& survey) {
  std::map<std::int64_t, std::size_t> pose_at;
  for (std::size_t k = 0; k < survey.poses.size(); ++k) {
    pose_at.emplace(survey.poses[k].stamp_ns, k);
  }
  std::vector<RecordPair> pairs;
  for (std::size_t k = 0; k < survey.clouds.size(); ++k) {
    const auto pose = pose_at.find(survey.clouds[k].stamp_ns);
    if (pose != pose_at.end()) pairs.push_back({k, pose->second});
  }
  return pairs;
}

}  // namespace

std::string findCloudTopic(const TopicTypes& types,
                           const std::string& wanted,
                           const std::string& where) {
  return chooseOrOnly(types, wanted, topics::kCloudType,
                      [&](auto& name) { return chooseCloudTopic(types, name, where); });
}

BagTopics findDrive(const TopicTypes& types, const BagTopics& wanted, const std::string& where) {
  BagTopics found;
  found.cloud = findCloudTopic(types, wanted.cloud, where);
  found.odometry = chooseOrOnly(types, wanted.odometry, topics::kOdometryType, [&](auto& name) {
    return chooseOdometryTopic(types, name, where);
  });
  return found;
}

std::vector<RecordPair> inOrder(const BagSurvey& survey) {
  std::vector<RecordPair> accepted;
  std::int64_t last = 0;  // ROS takes stamp 0 for "not set", and so do we
  for (const RecordPair& pair : survey.pairs) {
    const std::int64_t stamp = survey.clouds[pair.cloud].stamp_ns;
    if (stamp <= last) continue;
    last = stamp;
    accepted.push_back(pair);
  }
  return accepted;
}

std::string cloudAt(const BagSurvey& survey, std::size_t cloud) {
  constexpr double kSeconds = 1e-9;
  const std::int64_t after = survey.clouds[cloud].stamp_ns - survey.clouds.front().stamp_ns;
  return "cloud " + std::to_string(cloud) + " at " +
         fixed(static_cast<double>(after) * kSeconds, 1) + " s";
}

void surveyTopics(const rosbag::Bag& bag, BagSurvey& survey) {
  survey.types = topicTypes(bag);
  for (const auto& [topic, type] : survey.types) {
    survey.messages[topic] = rosbag::View(bag, rosbag::TopicQuery(topic)).size();
  }
}

void surveyDrive(const rosbag::Bag& bag,
                 const BagTopics& wanted,
                 const std::string& where,
                 BagSurvey& survey) {
  survey.topics = findDrive(survey.types, wanted, where);
  try {
    readRecords(bag, survey);
  } catch (const IoError&) {
    throw;
  } catch (const std::exception& error) {
    survey.break_off = error.what();
  }
  survey.pairs = pairUp(survey);
}

}  // namespace segdf

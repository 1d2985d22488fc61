// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_check.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include <tf2_eigen/tf2_eigen.h>

#include <nav_msgs/Odometry.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/ros/bag_access.hpp"
#include "segdf/ros/bag_survey.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/drive_check.hpp"
#include "segdf/ros/scan_check.hpp"
#include "segdf/ros/tf_survey.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

std::string topicOr(const std::string& topic, const std::string& standard) {
  return topic == standard || "/" + topic == standard ? "" : topic;
}

/// For the shell: in quotes if it needs them.
std::string quoted(const std::string& text) {
  const std::string plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=~+,";
  if (text.find_first_not_of(plain) == std::string::npos) return text;
  std::string inside;
  for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return "'" + inside + "'";
}

void reportTopics(const BagSurvey& survey, BagReport& report) {
  for (const auto& [topic, type] : survey.types) {
    const std::string count = std::to_string(survey.messages.at(topic));
    std::string text = topic;
    text.append(" (").append(type).append(", ").append(count).append(" messages)");
    report.facts.emplace_back("topic", text);
  }
}

bool hasMessages(const BagSurvey& survey, BagReport& report) {
  if (!survey.clouds.empty() && !survey.poses.empty()) return true;
  const std::string& topic = survey.clouds.empty() ? survey.topics.cloud : survey.topics.odometry;
  const std::string reason = survey.break_off.empty() ? "" : " (" + survey.break_off + ")";
  report.errors.push_back("no message on " + topic + " can be read" + reason +
                          ": run 'rosbag reindex' on the bag, or record it again");
  return false;
}

void reportBreakOff(const BagSurvey& survey, BagReport& report) {
  if (survey.break_off.empty()) return;
  report.warnings.push_back(
      "the bag can be read up to " + cloudAt(survey, survey.clouds.size() - 1) + " only (" +
      survey.break_off + "): run 'rosbag reindex' on it, or use what there is");
}

void reportEmptyClouds(const BagSurvey& survey, BagReport& report) {
  std::size_t empty = 0;
  std::size_t first = 0;
  for (const RecordPair& pair : survey.pairs) {
    if (survey.clouds[pair.cloud].points > 0) continue;
    if (empty++ == 0) first = pair.cloud;
  }
  if (empty == 0) return;
  report.warnings.push_back(std::to_string(empty) +
                            " clouds have no points and are left out (the " + "first is " +
                            cloudAt(survey, first) + ")");
}

/// What is looked into, by the number of its cloud: its pose, and whether the one before is too.
struct Sample {
  std::size_t pose = 0;
  bool follows = false;
};

std::map<std::size_t, Sample> chooseSamples(const std::vector<RecordPair>& pairs, bool all) {
  std::map<std::size_t, Sample> samples;
  const std::size_t places = all ? pairs.size() : kSampledPlaces;
  for (std::size_t place = 0; place < places; ++place) {
    const std::size_t first = pairs.size() < 2 ? 0 : place * (pairs.size() - 1) / places;
    for (std::size_t k = first; k < pairs.size() && k < first + 2; ++k) {
      Sample& sample = samples[pairs[k].cloud];
      sample.pose = pairs[k].pose;
      sample.follows = sample.follows || k > first;
    }
  }
  return samples;
}

nav_msgs::Odometry toMessage(const PoseRecord& record) {
  nav_msgs::Odometry message;
  message.header.frame_id = record.frame;
  message.pose.pose = tf2::toMsg(record.pose);
  return message;
}

/// Looks into the sampled scans; gives up at the first that cannot be converted.
void lookIntoScans(const rosbag::Bag& bag,
                   const BagSurvey& survey,
                   const std::map<std::size_t, Sample>& samples,
                   BagReport& report) {
  ScanCheck check(isRegistered(survey));
  rosbag::View view(bag, rosbag::TopicQuery(survey.topics.cloud));
  std::size_t cloud = 0;
  auto next = samples.begin();
  for (auto at = view.begin(); at != view.end() && next != samples.end(); ++at, ++cloud) {
    if (cloud != next->first) continue;
    const auto message = readMessage<sensor_msgs::PointCloud2>(*at);
    if (next == samples.begin()) {
      report.facts.emplace_back("fields", describeFields(*message));
    }
    const Sample& sample = next->second;
    check.add(toScan(*message, toMessage(survey.poses[sample.pose]), survey.topics.cloud),
              sample.follows);
    ++next;
  }
  check.finish(report);
}

void checkDrive(const rosbag::Bag& bag,
                const BagSurvey& survey,
                const BagCheckOptions& options,
                BagReport& report) {
  if (!hasMessages(survey, report)) return;
  reportBreakOff(survey, report);
  checkStamps(survey, report);
  if (survey.pairs.empty()) return;
  checkFrames(survey, report);
  checkPoses(survey, report);
  if (!report.errors.empty()) return;  // scans without stamps, frames or poses tell nothing more
  reportEmptyClouds(survey, report);
  lookIntoScans(bag, survey, chooseSamples(inOrder(survey), options.all_scans), report);
}

/// Without odometry, poses may be in tf; only the launch file takes them from there.
void checkForTf(const rosbag::Bag& bag,
                const TopicTypes& types,
                const std::filesystem::path& file,
                const std::string& wanted_cloud) {
  const auto is_odometry = [](const auto& topic) { return topic.second == topics::kOdometryType; };
  if (std::any_of(types.begin(), types.end(), is_odometry)) return;
  const std::string where = "bag '" + file.string() + "'";
  const std::string cloud = findCloudTopic(types, wanted_cloud, where);
  const std::string arguments = tfArguments(bag, cloud);
  if (arguments.empty()) return;
  throw IoError(where +
                " has no odometry, but tf knows the poses: segdf_offline needs odometry, "
                "and live tf will do: " +
                launchCommand(file, {cloud, ""}, arguments));
}

}  // namespace

BagReport checkBag(const std::filesystem::path& file, const BagCheckOptions& options) {
  const std::unique_ptr<rosbag::Bag> bag = openBag(file);
  BagSurvey survey;
  BagReport report;
  try {
    surveyTopics(*bag, survey);
    reportTopics(survey, report);
    if (survey.types.empty()) throw IoError("bag '" + file.string() + "' is empty: record again");
    checkForTf(*bag, survey.types, file, options.topics.cloud);
    surveyDrive(*bag, options.topics, "bag '" + file.string() + "'", survey);
    report.topics = survey.topics;
    report.facts.emplace_back("clouds", survey.topics.cloud);
    report.facts.emplace_back("poses", survey.topics.odometry);
    checkDrive(*bag, survey, options, report);
  } catch (const std::exception& error) {
    report.errors.emplace_back(error.what());
  }
  return report;
}

std::string offlineCommand(const std::filesystem::path& bag, const BagTopics& topics) {
  const std::string odometry = topicOr(topics.odometry, topics::kOdometry);
  const bool found = topicOr(topics.cloud, topics::kRegisteredCloud).empty() ||
                     topicOr(topics.cloud, topics::kDeskewedCloud).empty();
  return "segdf_offline --bag " + quoted(bag.string()) +
         (found ? "" : " --cloud-topic " + quoted(topics.cloud)) +
         (odometry.empty() ? "" : " --odometry-topic " + quoted(odometry)) + " --output result";
}

std::string launchCommand(const std::filesystem::path& bag,
                          const BagTopics& topics,
                          const std::string& more) {
  const std::string cloud = topicOr(topics.cloud, topics::kRegisteredCloud);
  const std::string odometry = topicOr(topics.odometry, topics::kOdometry);
  return "roslaunch segdf segdf.launch " +
         quoted("bag:=" + std::filesystem::absolute(bag).lexically_normal().string()) +
         (cloud.empty() ? "" : " " + quoted("cloud_topic:=" + cloud)) +
         (odometry.empty() ? "" : " " + quoted("odometry_topic:=" + odometry)) +
         (more.empty() ? "" : " " + more) + " rviz:=true";
}

}  // namespace segdf

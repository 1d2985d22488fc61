// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/quantile.hpp"
#include "segdf/pipeline/jump_detector.hpp"
#include "segdf/ros/drive_check.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

constexpr double kSeconds = 1e-9;  // a nanosecond
constexpr double kDegrees = 180.0 / 3.14159265358979323846;

// No road vehicle turns nearly as fast.
constexpr double kTurnRate = 180.0;  // degrees a second
constexpr double kLeastTurn = 5.0;   // degrees that odometry may be off from scan to scan

constexpr const char* kIncremental = "/lio_sam/mapping/odometry_incremental";

const Pose& poseOf(const BagSurvey& survey, const RecordPair& pair) {
  return survey.poses[pair.pose].pose;
}

std::vector<RecordPair> withValidPose(const BagSurvey& survey) {
  std::vector<RecordPair> valid;
  for (const RecordPair& pair : inOrder(survey)) {
    if (isValidPose(poseOf(survey, pair))) valid.push_back(pair);
  }
  return valid;
}

/// From one pose to the next.
struct Step {
  std::size_t cloud = 0;  ///< at its end
  double seconds = 0.0;
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();  ///< metres
  double turned = 0.0;                              ///< degrees
};

std::vector<Step> stepsOf(const BagSurvey& survey, const std::vector<RecordPair>& pairs) {
  std::vector<Step> steps;
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    const Pose& from = poseOf(survey, pairs[k - 1]);
    const Pose& to = poseOf(survey, pairs[k]);
    Step step;
    step.cloud = pairs[k].cloud;
    step.seconds = static_cast<double>(survey.clouds[step.cloud].stamp_ns -
                                       survey.clouds[pairs[k - 1].cloud].stamp_ns) *
                   kSeconds;
    step.moved = to.translation() - from.translation();
    step.turned = Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle() * kDegrees;
    steps.push_back(step);
  }
  return steps;
}

/// The clouds before which the pipeline starts anew.
std::vector<std::size_t> findJumps(const BagSurvey& survey) {
  JumpDetector detector(InputConfig().max_jump);
  std::vector<std::size_t> clouds;
  for (const RecordPair& pair : survey.pairs) {
    Scan scan;
    scan.stamp_ns = survey.clouds[pair.cloud].stamp_ns;
    scan.pose = poseOf(survey, pair);
    if (detector.jumps(scan)) clouds.push_back(pair.cloud);
  }
  return clouds;
}

void reportJumps(const BagSurvey& survey, BagReport& report) {
  const std::vector<std::size_t> jumps = findJumps(survey);
  if (jumps.empty()) return;
  const bool other =
      survey.types.count(kIncremental) != 0 && survey.topics.odometry != kIncremental;
  report.warnings.push_back(
      std::to_string(jumps.size()) + " jumps of the pose by more than input.max_jump = " +
      fixed(InputConfig().max_jump, 1) + " m (the first before " + cloudAt(survey, jumps.front()) +
      "), as loop closures make them: segdf starts its window anew there, and things seen before "
      "and after one do not lie on each other" +
      (other ? std::string("; --odometry-topic ") + kIncremental + " has none" : ""));
}

/// The pipeline's jumps are ways only. A pose that is turned at once is a fault that it does not
/// see.
void reportSpins(const BagSurvey& survey, const std::vector<Step>& steps, BagReport& report) {
  std::size_t spins = 0;
  std::size_t first = 0;
  for (const Step& step : steps) {
    if (step.turned <= kLeastTurn + kTurnRate * step.seconds) continue;
    if (spins++ == 0) first = step.cloud;
  }
  if (spins == 0) return;
  report.warnings.push_back(std::to_string(spins) + " poses turn by more than " +
                            fixed(kTurnRate, 0) + " degrees a second (the first before " +
                            cloudAt(survey, first) +
                            "): segdf does not start anew there, and scans before and after do "
                            "not fit; name another odometry, or cut the bag there");
}

void reportWay(const std::vector<Step>& steps, BagReport& report) {
  double way = 0.0;
  std::vector<double> speeds;
  for (const Step& step : steps) {
    way += step.moved.norm();
    speeds.push_back(step.moved.norm() / step.seconds);
  }
  if (steps.empty()) return;
  report.facts.emplace_back("way",
                            fixed(way, 1) + " m, " + fixed(medianOf(speeds), 1) + " m/s (median)");
}

void reportInvalid(const BagSurvey& survey, BagReport& report) {
  std::size_t invalid = 0;
  std::size_t first = 0;
  for (const RecordPair& pair : survey.pairs) {
    if (isValidPose(poseOf(survey, pair))) continue;
    if (invalid++ == 0) first = pair.cloud;
  }
  if (invalid == 0) return;
  const std::string text = std::to_string(invalid) + " poses on " + survey.topics.odometry +
                           " are not finite or have no unit quaternion (the first is that of " +
                           cloudAt(survey, first) + ")";
  if (invalid == survey.pairs.size()) {
    report.errors.push_back(text + ": there is no other; name another topic with --odometry-topic");
  } else {
    report.warnings.push_back(text + ": their scans are left out");
  }
}

void reportChangedFrames(const BagSurvey& survey, BagReport& report) {
  const PoseRecord& first = survey.poses.front();
  for (const PoseRecord& pose : survey.poses) {
    if (pose.frame != first.frame) {
      report.errors.push_back("odometry on " + survey.topics.odometry +
                              " changes its frame from '" + first.frame + "' to '" + pose.frame +
                              "': cut the bag where it does");
      return;
    }
  }
  const std::string& cloud_frame = survey.clouds.front().frame;
  for (const CloudRecord& cloud : survey.clouds) {
    if (cloud.frame == cloud_frame) continue;
    report.warnings.push_back("clouds on " + survey.topics.cloud + " change their frame from '" +
                              cloud_frame + "' to '" + cloud.frame +
                              "': cut the bag where they do");
    return;
  }
}

/// Whose pose is it? LIO-SAM's child frame is a name only; others say what they mean.
void reportChildFrame(const BagSurvey& survey, BagReport& report) {
  const std::string& child = survey.poses.front().child_frame;
  const std::string& cloud = survey.clouds.front().frame;
  if (isRegistered(survey) || child.empty() || child == cloud) return;
  if (child == topics::kOdometryChildFrame) return;
  report.warnings.push_back("poses are those of '" + child + "', clouds are in '" + cloud +
                            "': segdf takes the poses as those of the clouds' frame; if the two "
                            "are not in one place, publish the poses of '" +
                            cloud + "'");
}

}  // namespace

bool isRegistered(const BagSurvey& survey) {
  const RecordPair& first = survey.pairs.front();
  return survey.clouds[first.cloud].frame == survey.poses[first.pose].frame;
}

void checkFrames(const BagSurvey& survey, BagReport& report) {
  const std::string& cloud = survey.clouds.front().frame;
  const std::string& pose = survey.poses.front().frame;
  report.facts.emplace_back(
      "frames",
      "clouds in '" + cloud + "', poses in '" + pose + "': clouds are taken as " +
          (isRegistered(survey) ? "registered, in the odometry frame" : "seen from the sensor"));
  if (cloud.empty() || pose.empty()) {
    report.warnings.push_back(std::string("header.frame_id of the ") +
                              (cloud.empty() ? "clouds" : "poses") +
                              " is empty: it tells whether clouds are registered; set it where "
                              "they are published");
  }
  reportChangedFrames(survey, report);
  reportChildFrame(survey, report);
}

void checkPoses(const BagSurvey& survey, BagReport& report) {
  reportInvalid(survey, report);
  const std::vector<Step> steps = stepsOf(survey, withValidPose(survey));
  reportWay(steps, report);
  reportJumps(survey, report);
  reportSpins(survey, steps, report);
}

}  // namespace segdf

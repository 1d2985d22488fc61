// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/instance_messages.hpp"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>
#include <tf2_eigen/tf2_eigen.h>

#include "segdf/ros/conversions.hpp"

namespace segdf {
namespace {

// The messages number classes and states as the enums do.
static_assert(static_cast<int>(ObjectClass::kVegetation) == LabelledInstance::CLASS_VEGETATION);
static_assert(static_cast<int>(ObjectClass::kBuilding) == LabelledInstance::CLASS_BUILDING);
static_assert(static_cast<int>(ObjectClass::kHighMobility) ==
              LabelledInstance::CLASS_HIGH_MOBILITY);
static_assert(static_cast<int>(ObjectClass::kUnknown) == LabelledInstance::CLASS_UNKNOWN);
static_assert(static_cast<int>(FrameStatus::kNotKeyFrame) == FrameReport::NOT_KEY_FRAME);
static_assert(static_cast<int>(FrameStatus::kEmpty) == FrameReport::EMPTY);
static_assert(static_cast<int>(FrameStatus::kInvalidPose) == FrameReport::INVALID_POSE);
static_assert(static_cast<int>(FrameStatus::kTimeBackwards) == FrameReport::TIME_BACKWARDS);

geometry_msgs::Vector3 toVector(const Eigen::Vector3d& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

LabelledInstance toMessage(const InstanceObservation& seen) {
  LabelledInstance message;
  message.id = seen.id;
  message.parent = seen.parent;
  message.object_class = static_cast<std::uint8_t>(seen.object_class);
  message.class_name = toString(seen.object_class);
  message.dynamic = static_cast<std::uint8_t>(seen.dynamic);
  message.points = seen.points;
  message.pose.position = tf2::toMsg(seen.center);
  message.pose.orientation =
      tf2::toMsg(Eigen::Quaterniond(Eigen::AngleAxisd(seen.yaw, Eigen::Vector3d::UnitZ())));
  message.size = toVector(seen.size);
  message.velocity = toVector(seen.velocity);
  message.static_votes = seen.static_votes;
  message.dynamic_votes = seen.dynamic_votes;
  message.needed_votes = seen.needed_votes;
  message.reason = toString(seen.reason);
  return message;
}

std::array<std::uint32_t, 5> countStates(const FrameResult& frame) {
  std::array<std::uint32_t, 5> counts{};
  for (const PointLabel& label : frame.labels) ++counts.at(static_cast<std::size_t>(label.state));
  return counts;
}

}  // namespace

LabelledInstanceArray toInstances(const FrameResult& frame, const std::string& frame_id) {
  LabelledInstanceArray array;
  array.header = toHeader(frame.scan, frame_id);
  for (const InstanceObservation& seen : frame.instances)
    array.instances.push_back(toMessage(seen));
  return array;
}

FrameReport toReport(const FrameResult& frame, const std::string& frame_id) {
  const std::array<std::uint32_t, 5> states = countStates(frame);
  const auto points = [&states](PointState state) {
    return states.at(static_cast<std::size_t>(state));
  };
  const StageTimes& t = frame.times;
  FrameReport report;
  report.header = toHeader(frame.scan, frame_id);
  report.index = static_cast<std::uint32_t>(frame.index);
  report.status = static_cast<std::uint8_t>(frame.status);
  report.points_unjudged = points(PointState::kUnjudged);
  report.points_ground = points(PointState::kGround);
  report.points_static = points(PointState::kStatic);
  report.points_dynamic = points(PointState::kDynamic);
  report.points_noise = points(PointState::kNoise);
  report.points_not_finite = static_cast<std::uint32_t>(frame.non_finite_points);
  report.instances = static_cast<std::uint32_t>(frame.instances.size());
  report.instances_dynamic = static_cast<std::uint32_t>(
      std::count_if(frame.instances.begin(), frame.instances.end(),
                    [](const InstanceObservation& seen) { return seen.dynamic; }));
  report.pose_misfit = static_cast<float>(frame.pose_misfit);
  report.processing_time =
      static_cast<float>(t.ground + t.normals + t.clustering + t.classification + t.dynamics);
  return report;
}

}  // namespace segdf

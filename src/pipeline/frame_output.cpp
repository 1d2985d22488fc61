// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/frame_output.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame_segments.hpp"

namespace segdf {

namespace {

std::vector<PointLabel> labelPoints(const KeyFrame& frame) {
  std::vector<PointLabel> labels(frame.scan.points.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (frame.seg.roles[i] == PointRole::kGround) labels[i].state = PointState::kGround;
    if (frame.seg.roles[i] == PointRole::kObject) labels[i].state = PointState::kNoise;
  }
  for (std::size_t s = 0; s < frame.seg.segments.size(); ++s) {
    const Segment& segment = frame.seg.segments[s];
    const Instance& instance = frame.instances[s];
    const PointState state = instance.dynamic ? PointState::kDynamic : PointState::kStatic;
    for (std::uint32_t i : segment.points) labels[i] = {instance.id, state, segment.object_class};
  }
  for (std::uint32_t i : frame.removed) labels[i].state = PointState::kDynamic;
  return labels;
}

/// What the other frames of the window said of a segment; none of one that was split off.
std::vector<Look> looksAt(const KeyFrame& frame, std::size_t segment) {
  std::vector<Look> looks;
  if (!frame.evidence || segment >= frame.evidence->votes.size()) return looks;
  for (const PairVote& vote : frame.evidence->votes[segment]) {
    if (!vote.informative) continue;
    looks.push_back(
        {vote.scan, static_cast<double>(vote.seconds), vote.free, vote.free + vote.hit});
  }
  return looks;
}

InstanceObservation observationOf(const KeyFrame& frame, std::size_t s) {
  const Segment& segment = frame.seg.segments[s];
  const Instance& instance = frame.instances[s];
  const Pose& pose = frame.scan.pose;
  InstanceObservation seen;
  seen.id = instance.id;
  seen.parent = instance.parent;
  seen.object_class = segment.object_class;
  seen.dynamic = instance.dynamic;
  seen.fused = instance.fused;
  seen.points = static_cast<std::uint32_t>(segment.points.size());
  seen.static_votes = instance.static_votes;
  seen.dynamic_votes = instance.dynamic_votes;
  seen.needed_votes = instance.needed_votes;
  seen.reason = instance.reason;
  seen.looks = looksAt(frame, s);
  seen.center = centerOf(frame, s);
  seen.size = segment.box.size.cast<double>();
  const auto yaw = static_cast<double>(segment.box.yaw);
  const Eigen::Vector3d axis = pose.linear() * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0);
  seen.yaw = std::atan2(axis.y(), axis.x());
  seen.velocity = instance.velocity;
  return seen;
}

}  // namespace

FrameResult mappedResult(KeyFrame frame) {
  FrameResult result;
  result.labels = labelPoints(frame);
  for (std::size_t s = 0; s < frame.seg.segments.size(); ++s) {
    result.instances.push_back(observationOf(frame, s));
  }
  std::sort(result.instances.begin(), result.instances.end(),
            [](const InstanceObservation& a, const InstanceObservation& b) { return a.id < b.id; });
  result.pose_misfit = frame.pose_misfit;
  result.non_finite_points = frame.seg.non_finite_points;
  result.times = frame.times;
  result.scan = std::move(frame.scan);
  return result;
}

FrameResult rejectedResult(Scan scan, FrameStatus status) {
  FrameResult result;
  result.status = status;
  result.labels.resize(scan.points.size());
  result.pose_misfit = std::numeric_limits<double>::quiet_NaN();
  result.non_finite_points = static_cast<std::size_t>(std::count_if(
      scan.points.begin(), scan.points.end(), [](const Point& p) { return !isFinite(p); }));
  result.scan = std::move(scan);
  return result;
}

}  // namespace segdf

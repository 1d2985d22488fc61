// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/scan_gate.hpp"

#include <algorithm>

#include "segdf/segmentation/segmenter.hpp"

namespace segdf {

namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

bool hasUsablePoint(const Scan& scan, const InputConfig& config) {
  const std::vector<PointRole> roles = selectPoints(scan.points, config);
  return std::any_of(roles.begin(), roles.end(),
                     [](PointRole role) { return role != PointRole::kUnused; });
}

}  // namespace

FrameStatus ScanGate::admit(const Scan& scan) {
  if (!isValidPose(scan.pose)) return FrameStatus::kInvalidPose;
  if (last_stamp_ns_ && scan.stamp_ns <= *last_stamp_ns_) return FrameStatus::kTimeBackwards;
  if (!hasUsablePoint(scan, config_)) return FrameStatus::kEmpty;
  last_stamp_ns_ = scan.stamp_ns;
  if (!isKeyFrame(scan)) return FrameStatus::kNotKeyFrame;
  last_key_ = KeyPose{scan.pose, scan.stampSeconds()};
  return FrameStatus::kMapped;
}

bool ScanGate::isKeyFrame(const Scan& scan) const {
  if (!last_key_ || config_.keyframe_distance <= 0.0) return true;
  const double waited = scan.stampSeconds() - last_key_->seconds;
  if (config_.keyframe_time > 0.0 && waited >= config_.keyframe_time) return true;
  const Pose moved = last_key_->pose.inverse() * scan.pose;
  if (moved.translation().norm() >= config_.keyframe_distance) return true;
  const double turn = Eigen::AngleAxisd(moved.linear()).angle() * kDegrees;
  return config_.keyframe_angle > 0.0 && turn >= config_.keyframe_angle;
}

}  // namespace segdf

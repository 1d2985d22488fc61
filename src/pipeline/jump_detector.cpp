// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/jump_detector.hpp"

namespace segdf {
namespace {

constexpr double kAcceleration = 10.0;  // m/s^2, about what tyres hold

double secondsBetween(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace

bool JumpDetector::jumps(const Scan& scan) {
  if (max_jump_ <= 0.0 || !isValidPose(scan.pose)) return false;
  if (last_ && scan.stamp_ns <= last_->stamp_ns) return false;
  const Place now{scan.stamp_ns, scan.pose.translation()};
  const bool jump = before_ && isUnexplained(now);
  before_ = jump ? std::nullopt : last_;
  last_ = now;
  return jump;
}

bool JumpDetector::isUnexplained(const Place& now) const {
  const double earlier = secondsBetween(before_->stamp_ns, last_->stamp_ns);
  const double passed = secondsBetween(last_->stamp_ns, now.stamp_ns);
  const Eigen::Vector3d velocity = (last_->position - before_->position) / earlier;
  const Eigen::Vector3d expected = last_->position + velocity * passed;
  const double explained = 0.5 * kAcceleration * passed * (passed + earlier);
  return (now.position - expected).norm() > max_jump_ + explained;
}

}  // namespace segdf

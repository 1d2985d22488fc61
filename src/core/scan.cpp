// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/scan.hpp"

namespace segdf {

namespace {
constexpr double kOrthonormalTolerance = 1e-3;
}  // namespace

bool isValidPose(const Pose& pose) {
  if (!pose.matrix().allFinite()) return false;
  const Eigen::Matrix3d rotation = pose.linear();
  const Eigen::Matrix3d error = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  return error.cwiseAbs().maxCoeff() < kOrthonormalTolerance && rotation.determinant() > 0.0;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/pose_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace segdf {

namespace {

constexpr int kMaxSteps = 20;
constexpr double kFirstScale = 0.5;  // metres, of the robust kernel
constexpr double kLastScale = 0.08;
constexpr std::size_t kCoarseStride = 4;
constexpr std::size_t kEnough = 1000;  // points: twice as many make no pair better
constexpr double kScaleRatio = 0.7;        // from step to step
constexpr double kDoneTranslation = 2e-3;  // metres
constexpr double kDoneRotation = 2e-4;     // rad
constexpr double kMaxTranslation = 1.5;
constexpr double kMaxRotation = 0.06;
constexpr float kQualityReach = 30.0F;
constexpr float kQualityResidual = 0.1F;
constexpr std::size_t kMinMatches = 50;
constexpr double kBetter = 0.02;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct Match {
  Eigen::Vector3f place;  // in the frame of the planes
  const SmallPlane* plane;

  float residual() const { return plane->normal.dot(place - plane->mean); }
};

/// Calls visit(match) for every source point that falls into a voxel with a plane.
template <class Visit>
void forEachMatch(const Pose& pose,
                  const std::vector<Eigen::Vector3f>& source,
                  std::size_t stride,
                  const PlaneMap& target,
                  const Visit& visit) {
  const Eigen::Matrix3f rotation = pose.linear().cast<float>();
  const Eigen::Vector3f translation = pose.translation().cast<float>();
  for (std::size_t k = 0; k < source.size(); k += stride) {
    const Eigen::Vector3f place = rotation * source[k] + translation;
    const SmallPlane* plane = target.at(place);
    if (plane != nullptr) visit(Match{place, plane});
  }
}

std::size_t fineStride(const std::vector<Eigen::Vector3f>& source) {
  return std::max<std::size_t>(1, source.size() / kEnough);
}

/// One Gauss-Newton step: rotation vector, then translation. Zero when the pair gives no hold.
Vector6 step(const Pose& pose,
             const std::vector<Eigen::Vector3f>& source,
             const PlaneMap& target,
             double scale) {
  Eigen::Matrix<float, 6, 6> normal = Eigen::Matrix<float, 6, 6>::Zero();
  Eigen::Matrix<float, 6, 1> right = Eigen::Matrix<float, 6, 1>::Zero();
  std::size_t matches = 0;
  const auto squared_scale = static_cast<float>(scale * scale);
  // While the kernel is wide a part of the points shows the way.
  const std::size_t stride = scale > kLastScale ? kCoarseStride : fineStride(source);
  forEachMatch(pose, source, stride, target, [&](const Match& match) {
    const float r = match.residual();
    const float kernel = squared_scale / (squared_scale + r * r);
    const Eigen::Vector3f& x = match.place;
    const Eigen::Vector3f& n = match.plane->normal;
    Eigen::Matrix<float, 6, 1> jacobian;
    jacobian << x.y() * n.z() - x.z() * n.y(), x.z() * n.x() - x.x() * n.z(),
        x.x() * n.y() - x.y() * n.x(), n;
    const Eigen::Matrix<float, 6, 1> weighted = (kernel * kernel) * jacobian;
    normal.noalias() += weighted * jacobian.transpose();
    right -= r * weighted;
    ++matches;
  });
  if (matches < kMinMatches) return Vector6::Zero();
  // A little damping holds directions in which the scene says nothing (a straight street).
  const Matrix6 damped = normal.cast<double>() + Matrix6::Identity();
  return damped.ldlt().solve(right.cast<double>());
}

Pose moved(const Pose& pose, const Vector6& change) {
  const double angle = change.head<3>().norm();
  const Eigen::Vector3d axis =
      angle > 0.0 ? Eigen::Vector3d(change.head<3>() / angle) : Eigen::Vector3d::UnitZ();
  return Eigen::Translation3d(change.tail<3>()) * Eigen::AngleAxisd(angle, axis) * pose;
}

double qualityOf(const Pose& pose,
                 const std::vector<Eigen::Vector3f>& source,
                 const PlaneMap& target) {
  std::size_t near = 0;
  std::size_t good = 0;
  forEachMatch(pose, source, fineStride(source), target, [&](const Match& match) {
    if (match.place.squaredNorm() > kQualityReach * kQualityReach) return;
    ++near;
    good += std::abs(match.residual()) < kQualityResidual ? 1 : 0;
  });
  return near < kMinMatches ? 0.0 : static_cast<double>(good) / static_cast<double>(near);
}

bool isNear(const Pose& refined, const Pose& given) {
  const Pose change = refined * given.inverse();
  return change.translation().norm() <= kMaxTranslation &&
         Eigen::AngleAxisd(change.linear()).angle() <= kMaxRotation;
}

}  // namespace

PairPose refinePair(const Pose& to_T_from,
                    const std::vector<Eigen::Vector3f>& source,
                    const PlaneMap& target) {
  Pose pose = to_T_from;
  double scale = kFirstScale;
  for (int k = 0; k < kMaxSteps; ++k) {
    const Vector6 change = step(pose, source, target, scale);
    pose = moved(pose, change);
    const bool still =
        change.head<3>().norm() < kDoneRotation && change.tail<3>().norm() < kDoneTranslation;
    if (still && scale <= kLastScale) break;
    scale = std::max(kLastScale, scale * kScaleRatio);
  }
  const double given_quality = qualityOf(to_T_from, source, target);
  const double quality = isNear(pose, to_T_from) ? qualityOf(pose, source, target) : 0.0;
  if (quality >= given_quality + kBetter) return {pose, quality, true};
  return {to_T_from, given_quality, false};
}

}  // namespace segdf

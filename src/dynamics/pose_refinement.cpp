// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/pose_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace segdf {

namespace {

constexpr int kMaxSteps = 20;
constexpr double kFirstScale = 0.5;  // metres, of the robust kernel
constexpr double kLastScale = 0.08;
constexpr std::size_t kCoarseStride = 4;
constexpr std::size_t kEnough = 1000;      // points: twice as many make no pair better
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

/// Meets the points of one scan with the planes of another, pose after pose.
class Matcher {
 public:
  Matcher(const std::vector<Eigen::Vector3f>& source, const PlaneMap& target)
      : source_(source), target_(target), last_(source.size()) {}

  /// Every so many-th point is enough to be exact.
  std::size_t fineStride() const { return std::max<std::size_t>(1, source_.size() / kEnough); }

  /// Calls visit(match) for every source point that falls into a voxel with a plane.
  template <class Visit>
  void forEachMatch(const Pose& pose, std::size_t stride, const Visit& visit) {
    const Eigen::Matrix3f rotation = pose.linear().cast<float>();
    const Eigen::Vector3f translation = pose.translation().cast<float>();
    for (std::size_t k = 0; k < source_.size(); k += stride) {
      const Eigen::Vector3f place = rotation * source_[k] + translation;
      const std::uint64_t voxel = target_.voxelOf(place);
      // Poses differ by so little that most points stay in their voxels.
      if (voxel != last_[k].voxel) last_[k] = {voxel, target_.planeOf(voxel)};
      if (last_[k].plane != nullptr) visit(Match{place, last_[k].plane});
    }
  }

 private:
  struct Answer {
    std::uint64_t voxel = ~std::uint64_t{0};  // none has this key
    const SmallPlane* plane = nullptr;
  };

  const std::vector<Eigen::Vector3f>& source_;
  const PlaneMap& target_;
  std::vector<Answer> last_;  // for each source point
};

/// One Gauss-Newton step: rotation vector, then translation. Zero when the pair gives no hold.
Vector6 step(const Pose& pose, Matcher& matcher, double scale) {
  Eigen::Matrix<float, 6, 6> normal = Eigen::Matrix<float, 6, 6>::Zero();
  Eigen::Matrix<float, 6, 1> right = Eigen::Matrix<float, 6, 1>::Zero();
  std::size_t matches = 0;
  const auto squared_scale = static_cast<float>(scale * scale);
  // While the kernel is wide a part of the points shows the way.
  const std::size_t stride = scale > kLastScale ? kCoarseStride : matcher.fineStride();
  matcher.forEachMatch(pose, stride, [&](const Match& match) {
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

double qualityOf(const Pose& pose, Matcher& matcher) {
  std::size_t near = 0;
  std::size_t good = 0;
  matcher.forEachMatch(pose, matcher.fineStride(), [&](const Match& match) {
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
  Matcher matcher(source, target);
  Pose pose = to_T_from;
  double scale = kFirstScale;
  for (int k = 0; k < kMaxSteps; ++k) {
    const Vector6 change = step(pose, matcher, scale);
    pose = moved(pose, change);
    const bool still =
        change.head<3>().norm() < kDoneRotation && change.tail<3>().norm() < kDoneTranslation;
    if (still && scale <= kLastScale) break;
    scale = std::max(kLastScale, scale * kScaleRatio);
  }
  const double given_quality = qualityOf(to_T_from, matcher);
  const double quality = isNear(pose, to_T_from) ? qualityOf(pose, matcher) : 0.0;
  if (quality >= given_quality + kBetter) return {pose, quality, true};
  return {to_T_from, given_quality, false};
}

}  // namespace segdf

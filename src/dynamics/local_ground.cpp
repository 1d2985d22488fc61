// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/local_ground.hpp"

#include <cstddef>
#include <cstdint>

#include <Eigen/Cholesky>

namespace segdf {

namespace {

constexpr float kReach = 4.0F;            // metres around the area
constexpr std::size_t kMinPoints = 20;    // for a plane
constexpr std::size_t kMaxPoints = 2000;  // more tell nothing new
constexpr int kSteps = 8;
// Square metres that hold the plane level where the ground is seen on one side only.
constexpr double kFlatness = 2.0;
// Metres, of the kernel: what is above the plane may be a wheel, what is below is ground.
constexpr double kScaleAbove = 0.03;
constexpr double kScaleBelow = 0.10;
// Metres from the area at which ground counts a quarter: who stands on the sidewalk does not stand
// on the road beside it.
constexpr double kNear = 2.0;

/// A ground point as the fit uses it.
struct Sample {
  Eigen::Vector4d row;  ///< place from the centre, metres; 1; z, metres
  double weight = 0.0;  ///< by the distance from the area
};

/// Some kMaxPoints of the points.
std::vector<Sample> thinned(const std::vector<Eigen::Vector3f>& ground,
                            const Eigen::AlignedBox2f& area,
                            const Eigen::Vector2f& center) {
  std::vector<Sample> samples;
  const std::size_t stride = ground.size() / kMaxPoints + 1;
  for (std::size_t k = 0; k < ground.size(); k += stride) {
    const Eigen::Vector2f place = ground[k].head<2>();
    const Eigen::Vector2d from_center = (place - center).cast<double>();
    const auto away = static_cast<double>(area.exteriorDistance(place));
    const double near = 1.0 / (1.0 + away * away / (kNear * kNear));
    samples.push_back(
        {{from_center.x(), from_center.y(), 1.0, static_cast<double>(ground[k].z())}, near * near});
  }
  return samples;
}

}  // namespace

LocalGround::LocalGround(const KeyFrame& frame,
                         const AreaIndex& places,
                         const Eigen::AlignedBox2f& area)
    : frame_(frame) {
  Eigen::AlignedBox2f around = area;
  around.min().array() -= kReach;
  around.max().array() += kReach;
  std::vector<Eigen::Vector3f> ground;
  for (std::uint32_t i : places.pointsIn(around)) {
    if (frame.seg.roles[i] != PointRole::kGround) continue;
    ground.push_back(frame.scan.points[i].position());
  }
  if (ground.size() >= kMinPoints) fit(ground, area);
}

void LocalGround::fit(const std::vector<Eigen::Vector3f>& ground, const Eigen::AlignedBox2f& area) {
  for (const Eigen::Vector3f& x : ground) center_ += x.head<2>();
  center_ /= static_cast<float>(ground.size());
  const std::vector<Sample> samples = thinned(ground, area, center_);
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();
  for (int step = 0; step < kSteps; ++step) {
    // Normal equations, and in the last column their right side.
    Eigen::Matrix4d sums = Eigen::Matrix4d::Zero();
    const Eigen::Vector4d over(-plane.x(), -plane.y(), -plane.z(), 1.0);
    for (const Sample& sample : samples) {
      const double off = step == 0 ? 0.0 : sample.row.dot(over);
      const double scaled = off / (off > 0.0 ? kScaleAbove : kScaleBelow);
      const double root = 1.0 / (1.0 + scaled * scaled);
      const double weight = root * root * sample.weight;
      sums += weight * sample.row * sample.row.transpose();
    }
    Eigen::Matrix3d normal = sums.topLeftCorner<3, 3>();
    normal.diagonal().head<2>().array() += kFlatness * normal(2, 2);  // (2, 2): the sum of weights
    plane = normal.ldlt().solve(sums.col(3).head<3>());
  }
  plane_ = plane.cast<float>();
  known_ = true;
}

float LocalGround::heightOf(std::size_t i) const {
  if (!known_) return frame_.seg.height[i];
  const Eigen::Vector3f x = frame_.scan.points[i].position();
  return x.z() - (plane_.head<2>().dot(x.head<2>() - center_) + plane_.z());
}

}  // namespace segdf

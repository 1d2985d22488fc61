// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/plane_map.hpp"

#include <cstddef>
#include <cstring>

#include <Eigen/Eigenvalues>

namespace segdf {

namespace {

constexpr float kReach = 60.0F;  // metres; farther planes have too few points to be planes
constexpr std::uint32_t kMinPoints = 6;
constexpr float kMaxThickness = 0.0025F;  // m^2, smallest eigenvalue
constexpr float kObjectCell = 1.0F;
constexpr float kGroundCell = 3.0F;

/// Moments about the first point of a voxel, so that single precision is enough. All are four
/// wide, as the processor adds them; in the fourth is what points have there, and nobody asks.
struct Moments {
  Eigen::Array4f origin = Eigen::Array4f::Zero();
  Eigen::Array4f sum = Eigen::Array4f::Zero();
  Eigen::Array<float, 4, 3> products = Eigen::Array<float, 4, 3>::Zero();
  std::uint32_t count = 0;

  void add(const Point& p) {
    static_assert(offsetof(Point, z) == 2 * sizeof(float));
    Eigen::Array4f x;
    std::memcpy(x.data(), &p, sizeof(x));
    if (count++ == 0) origin = x;
    const Eigen::Array4f d = x - origin;
    sum += d;
    for (Eigen::Index k = 0; k < 3; ++k) products.col(k) += d * d[k];
  }
  Eigen::Vector3f place() const { return origin.head<3>(); }
};

bool isPlane(const Moments& moments, SmallPlane& plane) {
  if (moments.count < kMinPoints) return false;
  const auto n = static_cast<float>(moments.count);
  const Eigen::Vector3f mean = moments.sum.head<3>() / n;
  const Eigen::Matrix3f products = moments.products.topRows<3>() / n;
  const Eigen::Matrix3f covariance = products - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance.cast<double>());
  const Eigen::Vector3d& values = solver.eigenvalues();
  // A line has no plane: its second eigenvalue is as small as the first.
  if (values[0] > static_cast<double>(kMaxThickness) || values[1] < 4.0 * values[0]) return false;
  plane.mean = moments.place() + mean;
  plane.normal = solver.eigenvectors().col(0).cast<float>();
  return true;
}

bool isNear(const Point& p) { return p.position().squaredNorm() < kReach * kReach; }

}  // namespace

PlaneMap::PlaneMap(const std::vector<Point>& points, const std::vector<PointRole>& roles) {
  VoxelIndex voxels(kVoxel);
  std::vector<Moments> moments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused || !isNear(points[i])) continue;
    const auto voxel = static_cast<std::size_t>(voxels.insert(points[i].position()));
    if (voxel == moments.size()) moments.emplace_back();
    moments[voxel].add(points[i]);
  }
  for (const Moments& voxel : moments) {
    SmallPlane plane;
    if (!isPlane(voxel, plane)) continue;
    voxels_.insert(voxel.place());
    planes_.push_back(plane);
  }
}

std::vector<Eigen::Vector3f> thinForRegistration(const std::vector<Point>& points,
                                                 const std::vector<PointRole>& roles) {
  VoxelIndex objects(kObjectCell);
  VoxelIndex ground(kGroundCell);
  std::vector<Eigen::Vector3f> thinned;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused || !isNear(points[i])) continue;
    VoxelIndex& cells = roles[i] == PointRole::kGround ? ground : objects;
    const std::size_t before = cells.size();
    cells.insert(points[i].position());
    if (cells.size() > before) thinned.push_back(points[i].position());
  }
  return thinned;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/plane_map.hpp"

#include <Eigen/Eigenvalues>

namespace segdf {

namespace {

constexpr float kReach = 60.0F;  // metres; farther planes have too few points to be planes
constexpr std::uint32_t kMinPoints = 6;
constexpr float kMaxThickness = 0.0025F;  // m^2, smallest eigenvalue
constexpr float kObjectCell = 1.0F;
constexpr float kGroundCell = 3.0F;

/// Moments about the first point of a voxel, so that single precision is enough.
struct Moments {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
  std::uint32_t count = 0;

  void add(const Eigen::Vector3f& x) {
    if (count++ == 0) origin = x;
    const Eigen::Vector3f d = x - origin;
    sum += d;
    products += d * d.transpose();
  }
};

bool isPlane(const Moments& moments, SmallPlane& plane) {
  if (moments.count < kMinPoints) return false;
  const auto n = static_cast<float>(moments.count);
  const Eigen::Vector3f mean = moments.sum / n;
  const Eigen::Matrix3f covariance = moments.products / n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance.cast<double>());
  const Eigen::Vector3d& values = solver.eigenvalues();
  // A line has no plane: its second eigenvalue is as small as the first.
  if (values[0] > static_cast<double>(kMaxThickness) || values[1] < 4.0 * values[0]) return false;
  plane.mean = moments.origin + mean;
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
    const Eigen::Vector3f x = points[i].position();
    const auto voxel = static_cast<std::size_t>(voxels.insert(x));
    if (voxel == moments.size()) moments.emplace_back();
    moments[voxel].add(x);
  }
  for (const Moments& voxel : moments) {
    SmallPlane plane;
    if (!isPlane(voxel, plane)) continue;
    voxels_.insert(voxel.origin);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>

#include <Eigen/Eigenvalues>

#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

constexpr double kTwoPi = 2.0 * 3.14159265358979323846;
constexpr std::size_t kZones = 4;
// Patchwork++'s grid: rings and sectors of each zone.
constexpr std::array<int, kZones> kRings{2, 4, 4, 4};
constexpr std::array<int, kZones> kSectors{16, 32, 54, 32};
// Reflections below ground lie lower than this multiple of the sensor's height, and lower than a
// road that falls away from the sensor as steeply as roads do.
constexpr double kReflectionRatio = 1.1;
constexpr double kSteepestRoad = 0.15;
// Below this ratio of the two larger eigenvalues a patch is one scan line, and its plane is not
// determined.
constexpr double kLineRatio = 0.01;

/// Concentric zone model: which patch a point belongs to.
class ConcentricZones {
 public:
  explicit ConcentricZones(const GroundConfig& c)
      : borders_{c.l_min, (7.0 * c.l_min + c.l_max) / 8.0, (3.0 * c.l_min + c.l_max) / 4.0,
                 (c.l_min + c.l_max) / 2.0, c.l_max} {
    int patches = 0;
    int rings = 0;
    for (std::size_t zone = 0; zone < kZones; ++zone) {
      first_patch_[zone] = patches;
      first_ring_[zone] = rings;
      patches += kRings[zone] * kSectors[zone];
      rings += kRings[zone];
    }
    patches_ = patches;
  }

  int patches() const { return patches_; }

  /// Patch of a point, -1 outside the zones.
  int patchOf(const Point& p) const {
    const double r = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
    if (!(r > borders_.front() && r <= borders_.back())) return -1;
    std::size_t zone = 0;
    while (r > borders_[zone + 1]) ++zone;
    const double width = (borders_[zone + 1] - borders_[zone]) / kRings[zone];
    const int ring = std::min(static_cast<int>((r - borders_[zone]) / width), kRings[zone] - 1);
    double azimuth = std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
    if (azimuth < 0.0) azimuth += kTwoPi;
    const int sector =
        std::min(static_cast<int>(azimuth / kTwoPi * kSectors[zone]), kSectors[zone] - 1);
    return first_patch_[zone] + ring * kSectors[zone] + sector;
  }

  /// Ring of a patch counted from the sensor over all zones.
  int ringOf(int patch) const {
    std::size_t zone = kZones - 1;
    while (patch < first_patch_[zone]) --zone;
    return first_ring_[zone] + (patch - first_patch_[zone]) / kSectors[zone];
  }

 private:
  std::array<double, kZones + 1> borders_;
  std::array<int, kZones> first_patch_{};
  std::array<int, kZones> first_ring_{};
  int patches_ = 0;
};

struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< upward
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double flatness = 0.0;  ///< smallest eigenvalue over the sum

  double signedDistance(const Eigen::Vector3d& x) const { return normal.dot(x - mean); }
};

using Indices = std::vector<std::uint32_t>;

Plane fitPlane(const std::vector<Point>& points, const Indices& indices) {
  Plane plane;
  for (std::uint32_t i : indices) plane.mean += points[i].position().cast<double>();
  plane.mean /= static_cast<double>(indices.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::uint32_t i : indices) {
    const Eigen::Vector3d d = points[i].position().cast<double>() - plane.mean;
    covariance += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& values = solver.eigenvalues();
  plane.normal = solver.eigenvectors().col(0);
  if (values[1] < kLineRatio * values[2]) {
    // One scan line: of all planes through it take the most upright.
    const Eigen::Vector3d line = solver.eigenvectors().col(2);
    const Eigen::Vector3d upright = Eigen::Vector3d::UnitZ() - line * line.z();
    if (upright.norm() > 1e-6) plane.normal = upright.normalized();
  }
  if (plane.normal.z() < 0.0) plane.normal = -plane.normal;
  const double sum = values.sum();
  plane.flatness = sum > 0.0 ? std::max(values[0], 0.0) / sum : 0.0;
  return plane;
}

/// Fits and judges the plane of one patch.
class PatchFitter {
 public:
  PatchFitter(const std::vector<Point>& points, const GroundConfig& config, double sensor_height)
      : points_(points), config_(config), sensor_height_(sensor_height) {}

  /// Ground points of the patch in `candidates`; empty when the patch has no ground.
  Indices fit(Indices candidates, int ring) const {
    const bool near = ring < kRings[0];
    if (near) dropReflections(candidates);
    if (near) dropWalls(candidates);
    if (candidates.size() < static_cast<std::size_t>(config_.n_min)) return {};
    Indices ground = seeds(candidates);
    Plane plane;
    for (int iteration = 0; iteration < config_.n_iter; ++iteration) {
      if (ground.size() < 3) return {};
      plane = fitPlane(points_, ground);
      ground = inliers(candidates, plane);
    }
    return accepts(plane, ring) ? ground : Indices{};
  }

 private:
  double z(std::uint32_t i) const { return static_cast<double>(points_[i].z); }

  void dropReflections(Indices& candidates) const {
    const auto is_reflection = [&](std::uint32_t i) {
      const auto range = static_cast<double>(points_[i].position().head<2>().norm());
      return z(i) < -kReflectionRatio * sensor_height_ - kSteepestRoad * range;
    };
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_reflection),
                     candidates.end());
  }

  /// Region-wise vertical planes (R-VPF of Patchwork++): a wall's foot must not seed the ground.
  void dropWalls(Indices& candidates) const {
    for (int iteration = 0; iteration < config_.n_iter; ++iteration) {
      if (candidates.size() < static_cast<std::size_t>(config_.n_min)) return;
      const Indices start = seeds(candidates);
      if (start.size() < 3) return;
      const Plane plane = fitPlane(points_, start);
      if (plane.normal.z() >= config_.uprightness) return;
      candidates.erase(
          std::remove_if(candidates.begin(), candidates.end(),
                         [&](std::uint32_t i) {
                           const Eigen::Vector3d x = points_[i].position().cast<double>();
                           return std::abs(plane.signedDistance(x)) < config_.wall_dist;
                         }),
          candidates.end());
    }
  }

  Indices seeds(const Indices& candidates) const {
    std::vector<double> heights(candidates.size());
    std::transform(candidates.begin(), candidates.end(), heights.begin(),
                   [&](std::uint32_t i) { return z(i); });
    const std::size_t low = std::min(heights.size(), static_cast<std::size_t>(config_.n_lpr));
    std::partial_sort(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(low),
                      heights.end());
    const double seed_height =
        std::accumulate(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(low), 0.0) /
        static_cast<double>(low);
    Indices result;
    for (std::uint32_t i : candidates) {
      if (z(i) < seed_height + config_.th_seed) result.push_back(i);
    }
    return result;
  }

  Indices inliers(const Indices& candidates, const Plane& plane) const {
    Indices result;
    for (std::uint32_t i : candidates) {
      const double d = plane.signedDistance(points_[i].position().cast<double>());
      if (d < config_.th_dist && d > -config_.below_tol) result.push_back(i);
    }
    return result;
  }

  bool accepts(const Plane& plane, int ring) const {
    if (plane.normal.z() < config_.uprightness) return false;
    const auto r = static_cast<std::size_t>(ring);
    if (r >= config_.elevation.size()) return true;
    const bool low_enough = plane.mean.z() <= -sensor_height_ + config_.elevation[r];
    return low_enough || plane.flatness < config_.flatness[r];
  }

  const std::vector<Point>& points_;
  const GroundConfig& config_;
  double sensor_height_;
};

std::vector<Indices> sortIntoPatches(const std::vector<Point>& points,
                                     const std::vector<PointRole>& roles,
                                     const ConcentricZones& zones) {
  std::vector<Indices> patches(static_cast<std::size_t>(zones.patches()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const int patch = zones.patchOf(points[i]);
    if (patch >= 0)
      patches[static_cast<std::size_t>(patch)].push_back(static_cast<std::uint32_t>(i));
  }
  return patches;
}

}  // namespace

double estimateSensorHeight(const std::vector<Point>& points,
                            const std::vector<PointRole>& roles,
                            const GroundConfig& config) {
  // Far enough to see ground under any mounting, near enough that slope does not matter.
  constexpr double kReach = 10.0;
  constexpr std::size_t kCells = 72;
  constexpr std::size_t kMinPoints = 10;
  constexpr double kLowQuantile = 0.1;
  std::vector<std::vector<double>> cells(kCells);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const Point& p = points[i];
    const double r = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
    if (r <= config.l_min || r > kReach) continue;
    const double turn =
        std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) / kTwoPi + 0.5;
    cells[std::min(static_cast<std::size_t>(turn * kCells), kCells - 1)].push_back(
        static_cast<double>(p.z));
  }
  std::vector<double> lows;
  for (auto& cell : cells) {
    if (cell.size() < kMinPoints) continue;
    const auto low = static_cast<std::ptrdiff_t>(kLowQuantile * static_cast<double>(cell.size()));
    std::nth_element(cell.begin(), cell.begin() + low, cell.end());
    lows.push_back(cell[static_cast<std::size_t>(low)]);
  }
  if (lows.empty()) return 0.0;
  const auto middle = lows.begin() + static_cast<std::ptrdiff_t>(lows.size() / 2);
  std::nth_element(lows.begin(), middle, lows.end());
  return std::max(0.0, -*middle);
}

Ground extractGround(const std::vector<Point>& points,
                     const std::vector<PointRole>& roles,
                     const GroundConfig& config,
                     int threads) {
  Ground ground;
  ground.is_ground.assign(points.size(), 0);
  ground.sensor_height = config.sensor_height > 0.0 ? config.sensor_height
                                                    : estimateSensorHeight(points, roles, config);
  const ConcentricZones zones(config);
  std::vector<Indices> patches = sortIntoPatches(points, roles, zones);
  const PatchFitter fitter(points, config, ground.sensor_height);
  parallelFor(patches.size(), threads, [&](std::size_t patch) {
    if (patches[patch].size() < static_cast<std::size_t>(config.n_min)) return;
    const int ring = zones.ringOf(static_cast<int>(patch));
    for (std::uint32_t i : fitter.fit(std::move(patches[patch]), ring)) ground.is_ground[i] = 1;
  });
  return ground;
}

}  // namespace segdf

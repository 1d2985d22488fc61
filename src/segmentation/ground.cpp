// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "segdf/core/parallel.hpp"
#include "segdf/segmentation/ground_zones.hpp"
#include "segdf/segmentation/moments.hpp"

namespace segdf {

namespace {

// Reflections below ground lie lower than this multiple of the sensor's height, and lower than a
// road that falls away from the sensor as steeply as roads do.
constexpr double kReflectionRatio = 1.1;
constexpr double kSteepestRoad = 0.15;
// Below this ratio of the two larger eigenvalues a patch is one scan line, and its plane is not
// determined.
constexpr double kLineRatio = 0.01;
// A plane near the sensor that holds a smaller share of its patch is one of reflections.
constexpr double kLeastShare = 0.02;

struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< upward; zero when not determined
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double flatness = 0.0;  ///< smallest eigenvalue over the sum

  double signedDistance(const Eigen::Vector3d& x) const { return normal.dot(x - mean); }
};

/// A patch with ground: its plane, and the points among which the ground is.
struct PatchGround {
  Plane plane;
  const PatchPoint* begin = nullptr;
  const PatchPoint* end = nullptr;
};

/// Plane through points whose offsets from `origin` are summed in `moments`.
Plane fitPlane(const Moments& moments, const Eigen::Vector3d& origin) {
  Plane plane;
  plane.mean = origin + moments.mean();
  const Eigen::Matrix3d covariance = moments.covariance();
  const Eigen::Vector3d values = eigenvaluesOf(covariance);
  Eigen::Vector3d normal = eigenvectorOf(covariance, values[0]);
  if (values[1] < kLineRatio * values[2]) {
    // One scan line: of all planes through it take the most upright.
    const Eigen::Vector3d line = eigenvectorOf(covariance, values[2]);
    normal = Eigen::Vector3d::UnitZ() - line * line.z();
  }
  plane.normal = normal.norm() > 1e-6 ? normal.normalized() : Eigen::Vector3d::Zero();
  if (plane.normal.z() < 0.0) plane.normal = -plane.normal;
  const double sum = values.sum();
  plane.flatness = sum > 0.0 ? values[0] / sum : 0.0;
  return plane;
}

/// Fits and judges the plane of one patch, whose points it may reorder.
class PatchFitter {
 public:
  PatchFitter(const GroundConfig& config, double sensor_height, int inner_rings)
      : config_(config), sensor_height_(sensor_height), inner_rings_(inner_rings) {}

  /// Ground of the points in [begin, end); none when they have no plane that can be ground.
  std::optional<PatchGround> fit(PatchPoint* begin, PatchPoint* end, int ring) const {
    const bool near = ring < inner_rings_;
    end = std::remove_if(begin, end, [&](const PatchPoint& p) { return isReflection(p); });
    if (near) end = dropWalls(begin, end);
    if (end - begin < config_.n_min) return std::nullopt;
    const Eigen::Vector3d origin = begin->position();
    Moments ground = seeds(begin, end, origin);
    Plane plane;
    for (int iteration = 0; iteration < config_.n_iter; ++iteration) {
      if (ground.count < 3.0) return std::nullopt;
      plane = fitPlane(ground, origin);
      ground = sum(begin, end, origin, [&](const PatchPoint& p) { return isOn(plane, p); });
    }
    if (near && ground.count < kLeastShare * static_cast<double>(end - begin)) {
      return fit(begin, dropUpTo(plane, begin, end), ring);
    }
    if (!accepts(plane, ring)) return std::nullopt;
    return PatchGround{plane, begin, end};
  }

  bool isOn(const Plane& plane, const PatchPoint& p) const {
    const double d = plane.signedDistance(p.position());
    return d < config_.th_dist && d > -config_.below_tol;
  }

 private:
  bool isReflection(const PatchPoint& p) const {
    const double range = p.position().head<2>().norm();
    return static_cast<double>(p.z) < -kReflectionRatio * sensor_height_ - kSteepestRoad * range;
  }

  template <class Condition>
  static Moments sum(const PatchPoint* begin,
                     const PatchPoint* end,
                     const Eigen::Vector3d& origin,
                     const Condition& takes) {
    Moments moments;
    for (const PatchPoint* p = begin; p != end; ++p) {
      if (!takes(*p)) continue;
      moments.add(static_cast<double>(p->x) - origin.x(), static_cast<double>(p->y) - origin.y(),
                  static_cast<double>(p->z) - origin.z());
    }
    return moments;
  }

  /// Region-wise vertical planes (R-VPF of Patchwork++): a wall's foot must not seed the ground.
  /// @returns the new end
  PatchPoint* dropWalls(PatchPoint* begin, PatchPoint* end) const {
    for (int iteration = 0; iteration < config_.n_iter; ++iteration) {
      if (end - begin < config_.n_min) return end;
      const Eigen::Vector3d origin = begin->position();
      const Moments start = seeds(begin, end, origin);
      if (start.count < 3.0) return end;
      const Plane plane = fitPlane(start, origin);
      if (plane.normal.z() >= config_.uprightness) return end;
      end = std::remove_if(begin, end, [&](const PatchPoint& p) {
        return std::abs(plane.signedDistance(p.position())) < config_.wall_dist;
      });
    }
    return end;
  }

  /// Takes out what is on the plane or below. @returns the new end
  PatchPoint* dropUpTo(const Plane& plane, PatchPoint* begin, PatchPoint* end) const {
    return std::remove_if(begin, end, [&](const PatchPoint& p) {
      return plane.signedDistance(p.position()) < config_.th_dist;
    });
  }

  /// The points near the height of the lowest.
  Moments seeds(const PatchPoint* begin,
                const PatchPoint* end,
                const Eigen::Vector3d& origin) const {
    std::vector<float> heights(static_cast<std::size_t>(end - begin));
    std::transform(begin, end, heights.begin(), [](const PatchPoint& p) { return p.z; });
    const auto low = heights.begin() + std::min(end - begin, std::ptrdiff_t{config_.n_lpr});
    std::nth_element(heights.begin(), low - 1, heights.end());
    std::sort(heights.begin(), low);
    // Their median instead of their mean: a few reflections below ground leave it in place.
    const auto level = static_cast<double>(*(heights.begin() + (low - heights.begin()) / 2));
    return sum(begin, end, origin, [&](const PatchPoint& p) {
      const double over = static_cast<double>(p.z) - level;
      return over < config_.th_seed && over > -config_.below_tol;
    });
  }

  bool accepts(const Plane& plane, int ring) const {
    if (plane.normal.z() < config_.uprightness) return false;
    const auto r = static_cast<std::size_t>(ring);
    if (r >= config_.elevation.size()) return true;
    const bool low_enough = plane.mean.z() <= -sensor_height_ + config_.elevation[r];
    return low_enough || plane.flatness < config_.flatness[r];
  }

  const GroundConfig& config_;
  double sensor_height_;
  int inner_rings_;
};

using PatchGrounds = std::vector<std::optional<PatchGround>>;

/// Takes out patches that float: a car's roof or bonnet that fills its patch is as flat and level
/// as ground, and so is the lowest line seen of a car whose foot is hidden, but it stands higher
/// over the ground next to it than a road climbs.
class FloatingPatches {
 public:
  FloatingPatches(const ConcentricZones& zones, const GroundConfig& config)
      : zones_(zones), config_(config) {}

  /// Each sweep goes away from what a patch is compared with, so that this has been judged.
  void drop(PatchGrounds& grounds) const {
    for (int patch = 0; patch < zones_.patches(); ++patch) {
      judge(
          patch, [&](int p) { return zones_.innerNeighbour(p); }, grounds);
    }
    for (int patch = 0; patch < zones_.patches(); ++patch) {
      judge(
          patch, [&](int p) { return zones_.sideNeighbour(p, -1); }, grounds);
    }
    for (int patch = zones_.patches() - 1; patch >= 0; --patch) {
      judge(
          patch, [&](int p) { return zones_.sideNeighbour(p, 1); }, grounds);
    }
  }

 private:
  /// @param step from a patch to the one next to it, -1 where there is none
  template <class Step>
  void judge(int patch, const Step& step, PatchGrounds& grounds) const {
    auto& ground = grounds[static_cast<std::size_t>(patch)];
    if (!ground) return;
    int next = step(patch);
    while (next >= 0 && !grounds[static_cast<std::size_t>(next)]) next = step(next);
    if (next < 0) return;
    if (floats(ground->plane, grounds[static_cast<std::size_t>(next)]->plane)) ground.reset();
  }

  bool floats(const Plane& plane, const Plane& below) const {
    const Eigen::Vector3d way = plane.mean - below.mean;
    return way.z() > config_.patch_step + config_.patch_slope * way.head<2>().norm();
  }

  const ConcentricZones& zones_;
  const GroundConfig& config_;
};

}  // namespace

Ground extractGround(const std::vector<Point>& points,
                     const std::vector<PointRole>& roles,
                     const std::vector<double>& turns,
                     const GroundConfig& config,
                     const RangeImageConfig& lasers,
                     int threads) {
  Ground ground;
  ground.is_ground.assign(points.size(), 0);
  ground.sensor_height = config.sensor_height > 0.0
                             ? config.sensor_height
                             : estimateSensorHeight(points, roles, turns, config);
  const ConcentricZones zones(config, lasers, ground.sensor_height);
  PatchedPoints patches = sortIntoPatches(points, roles, turns, zones, threads);
  const PatchFitter fitter(config, ground.sensor_height, zones.innerRings());
  const auto count = static_cast<std::size_t>(zones.patches());
  PatchGrounds grounds(count);
  parallelFor(count, threads, [&](std::size_t patch) {
    PatchPoint* first = patches.points.data();
    grounds[patch] = fitter.fit(first + patches.begin[patch], first + patches.begin[patch + 1],
                                zones.ringOf(static_cast<int>(patch)));
  });
  FloatingPatches(zones, config).drop(grounds);
  for (const auto& patch : grounds) {
    if (!patch) continue;
    for (const PatchPoint* p = patch->begin; p != patch->end; ++p) {
      if (fitter.isOn(patch->plane, *p)) ground.is_ground[p->index] = 1;
    }
  }
  return ground;
}

}  // namespace segdf

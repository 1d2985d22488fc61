// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// The concentric zone model of Patchwork (method.md 2.1): zones around the sensor, cut into rings
/// and sectors. Rings are counted from the sensor over all zones.
class ConcentricZones {
 public:
  static constexpr std::size_t kZones = 4;

  explicit ConcentricZones(const GroundConfig& config);

  int patches() const { return patches_; }
  /// Patch of a point, -1 outside the zones.
  int patchOf(const Point& p) const;
  int ringOf(int patch) const;
  /// The patch before the middle of this one on the way to the sensor, -1 for the innermost ring.
  int innerNeighbour(int patch) const;
  /// Rings 0 to innerRings() - 1 form the zone around the sensor.
  int innerRings() const;

 private:
  std::size_t zoneOf(int patch) const;

  std::array<double, kZones + 1> borders_;
  std::array<int, kZones> first_patch_{};
  std::array<int, kZones> first_ring_{};
  int patches_ = 0;
};

/// A point as the patches hold it.
struct PatchPoint {
  float x, y, z;
  std::uint32_t index;

  Eigen::Vector3d position() const {
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }
};

/// The points of a scan sorted into patches: patch k holds points[begin[k]] .. points[begin[k + 1]
/// - 1], in the order of the scan.
struct PatchedPoints {
  std::vector<PatchPoint> points;
  std::vector<std::size_t> begin;
};

PatchedPoints sortIntoPatches(const std::vector<Point>& points,
                              const std::vector<PointRole>& roles,
                              const ConcentricZones& zones,
                              int threads);

}  // namespace segdf

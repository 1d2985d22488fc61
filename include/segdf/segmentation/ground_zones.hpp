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
/// and sectors. The rings of a zone are equally wide. Of a sensor with few lasers such a ring would
/// hold one laser's line of the ground or none: there borders lie half-way between lasers, where
/// these meet level ground, and a ring holds two lasers or is 15 m wide.
class ConcentricZones {
 public:
  static constexpr std::size_t kZones = 4;

  /// @param lasers between whose elevations the lasers are taken to be evenly spread
  /// @param sensor_height over the ground, metres
  ConcentricZones(const GroundConfig& config, const RangeImageConfig& lasers, double sensor_height);

  int patches() const { return rings_.back().first_patch + rings_.back().sectors; }
  /// Patch of a point, -1 outside the zones. @param turn its azimuth, turnOf(y, x)
  int patchOf(const Point& p, double turn) const;
  /// Number of the equally wide ring, counted from the sensor, that holds the patch's middle.
  int ringOf(int patch) const { return rings_[indexOf(patch)].number; }
  /// The patch before the middle of this one on the way to the sensor, -1 for the innermost ring.
  int innerNeighbour(int patch) const;
  /// The patch beside it in its ring, at its left (1) or right (-1) seen from the sensor; wraps
  /// around.
  int sideNeighbour(int patch, int way) const;
  /// Rings 0 to innerRings() - 1 form the zone around the sensor.
  int innerRings() const;

 private:
  struct Ring {
    double end = 0.0;  ///< outer border, metres
    int number = 0;    ///< of the equally wide ring in the same place
    int sectors = 0;
    int first_patch = 0;
  };

  std::size_t indexOf(int patch) const;

  double begin_;
  std::vector<Ring> rings_;
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
                              const std::vector<double>& turns,
                              const ConcentricZones& zones,
                              int threads);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/mapping/map_point.hpp"

namespace segdf {

/// The static instance map S^ of (4) on a voxel grid: all kept points of the frames added so far,
/// one point per occupied voxel. Memory grows with the space seen, not with the time spent in it.
class StaticMap {
 public:
  /// @param voxel edge of the grid, metres, > 0. @throws std::invalid_argument otherwise
  explicit StaticMap(double voxel);

  /// Adds the ground, static and noise points of a mapped frame. A voxel keeps its first point.
  void add(const FrameResult& frame);
  void add(const MapPoint& point, std::size_t scan = 0);

  /// Takes out the points that an instance left in the scans in which it stood. A voxel is empty
  /// then, until another point comes. @return these points
  std::vector<MapPoint> revoke(const Revocation& revocation);

  /// In the order in which the voxels were first seen.
  const std::vector<MapPoint>& points() const { return points_; }

  void clear();

 private:
  struct KeyHash {
    std::size_t operator()(const Eigen::Vector3i& key) const;
  };

  Eigen::Vector3i keyOf(const MapPoint& point) const;

  double voxel_;
  std::unordered_set<Eigen::Vector3i, KeyHash> occupied_;
  std::vector<MapPoint> points_;
  std::vector<std::uint32_t> scans_;  ///< of the points, running numbers
};

/// The points on a coarser grid: the first of each voxel. @param voxel metres; 0 = all points
/// @throws std::invalid_argument if it is below 0 or not finite
std::vector<MapPoint> thinned(const std::vector<MapPoint>& points, double voxel);

}  // namespace segdf

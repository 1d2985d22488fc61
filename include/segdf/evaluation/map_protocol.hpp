// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/evaluation/point_grid.hpp"
#include "segdf/evaluation/point_scores.hpp"

namespace segdf {

/// The DynamicMap benchmark's protocol (peers.md 3.1, method.md 7.3): a labelled point of the truth
/// within range is kept iff a point of the map lies within the tolerance. Meant for maps at the
/// resolution of the scans: a map thinned to 0.1 m loses SA without having removed anything.
class MapProtocol {
 public:
  static constexpr double kTolerance = 0.05;  ///< metres, inclusive

  /// @param map points of the map to score, in the frame of the scans' poses, metres
  /// @param range metres from the sensor, inclusive
  explicit MapProtocol(const std::vector<Eigen::Vector3f>& map,
                       double range = 50.0,
                       int threads = 1)
      : map_(map, 2.0 * kTolerance), range_(range), threads_(threads) {}

  /// Adds one scan of the truth. @throws std::invalid_argument when points and labels differ in
  /// number
  void add(const Scan& scan, const std::vector<std::uint32_t>& truth);

  const PointScores& scores() const { return scores_; }

 private:
  PointGrid map_;
  double range_;
  int threads_;
  PointScores scores_;
};

/// A scan's point in the map frame, as static_map.pcd holds it: the pose in double, the result in
/// float.
Eigen::Vector3f inMapFrame(const Pose& map_T_sensor, const Point& point);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace segdf {

/// How well a map lies on a truth, and whether it would lie better when moved up or down: the
/// frames of published maps differ by the height of the sensor.
struct MapOverlap {
  double share = 0.0;         ///< of the truth's points that have a map point within 0.25 m
  double raise = 0.0;         ///< metres by which to raise the map for the best share
  double raised_share = 0.0;  ///< the share then
};

/// @param truth a few thousand static points of the truth, spread over the drive
/// @param map in the frame of the truth, or so one hopes
MapOverlap measureOverlap(const std::vector<Eigen::Vector3f>& truth,
                          const std::vector<Eigen::Vector3f>& map);

}  // namespace segdf

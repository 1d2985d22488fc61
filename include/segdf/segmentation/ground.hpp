// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// Ground of one scan, Algorithm 1 line 1: concentric zones with a plane per patch (method.md 2).
struct Ground {
  std::vector<std::uint8_t> is_ground;  ///< one for each point of the scan
  double sensor_height = 0.0;           ///< used, metres
};

/// Marks the ground among the points whose role is not kUnused. Patches are independent of each
/// other, the result does not depend on the threads or on earlier scans. @param turns azimuths of
/// the points, turnsOf(points) @param lasers the sensor's
Ground extractGround(const std::vector<Point>& points,
                     const std::vector<PointRole>& roles,
                     const std::vector<double>& turns,
                     const GroundConfig& config,
                     const RangeImageConfig& lasers,
                     int threads);

/// Height of the sensor over the ground around it, metres: the median over near polar cells of
/// their low points (method.md 2.3). Returns 0 when there is nothing near enough to tell.
double estimateSensorHeight(const std::vector<Point>& points,
                            const std::vector<PointRole>& roles,
                            const std::vector<double>& turns,
                            const GroundConfig& config);

/// Signed height over the local ground for each point, metres (method.md 2.4): median ground of 1 m
/// cells, empty cells filled from neighbours up to 8 cells away, else a plane at -sensor_height.
std::vector<float> heightOverGround(const std::vector<Point>& points,
                                    const Ground& ground,
                                    double l_max);

}  // namespace segdf

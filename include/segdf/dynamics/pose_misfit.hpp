// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/dynamics/frame.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// How far two scans disagree under their poses: the median, over a sample of object points of
/// `from` within 30 m that have a normal, of the distance along that normal to the nearest object
/// point of `to` (method.md 1, with the distance taken to the plane so that it measures the poses
/// and not the sampling). A point with no counterpart in the 27 cells around it counts as
/// kUnmatchedMisfit. Metres; NaN when fewer than 50 points can be compared.
double poseMisfit(const KeyFrame& from, const KeyFrame& to, const CurvedGrid& grid);

/// Stands for "farther than the search reaches". Metres.
constexpr double kUnmatchedMisfit = 1.0;

}  // namespace segdf

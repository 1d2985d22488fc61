// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Wheels, feet and sills lie within th_dist of the ground's plane, and would stay behind as
/// residue of an object that is removed. These two passes give them back to the object
/// (method.md 2.5).

/// Turns ground points into object points where the points of the same azimuth column climb from
/// them: each next laser up sees something within foot_reach in horizontal distance, steeper than
/// 45 degrees above the point, until foot_rise is reached. Ground does not climb like that: there,
/// the next laser up hits farther away.
void releaseStanding(const std::vector<Point>& points,
                     const RangeImage& image,
                     const GroundConfig& config,
                     int threads,
                     std::vector<PointRole>& roles);

/// Turns ground points more than touch_height over the local ground into object points when an
/// object point lies within touch_reach, among the neighbours in the range image; and once more
/// from those.
/// @param height of every point over the local ground, metres
void releaseTouching(const std::vector<Point>& points,
                     const RangeImage& image,
                     const std::vector<float>& height,
                     const GroundConfig& config,
                     int threads,
                     std::vector<PointRole>& roles);

}  // namespace segdf

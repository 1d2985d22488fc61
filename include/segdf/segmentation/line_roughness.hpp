// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Sets Surface::roughness: how far each point lies, along its ray seen from above, from the
/// straight line between its neighbours of the same cluster to the left and right in its row. It
/// needs one laser only, so that it is known where too few lasers hit an object for normals; what
/// is flat or evenly bent has little of it from any angle, foliage much. Not known where the
/// next return on a side is of something else.
/// @param cluster of each point, Clusters::kNoise for those in none
/// @param surfaces one for each point; nothing but their roughness is changed
void measureRoughness(const std::vector<Point>& points,
                      const RangeImage& image,
                      const std::vector<std::int32_t>& cluster,
                      int threads,
                      std::vector<Surface>& surfaces);

}  // namespace segdf

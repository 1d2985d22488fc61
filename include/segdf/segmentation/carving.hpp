// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/carve_config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Makes clusters of their own of persons who stand free, as the sensor sees them, of the cluster
/// that holds them. A cluster falls into pieces where neighbours in the range image differ by more
/// than `jump`. A piece becomes a cluster when it has the size of a person, lies in front of what is
/// beside it, and nothing of its cluster goes on to its left or right at the height of its chest.
/// What is no larger than a cyclist is left whole unless it holds two persons. A voxel goes where
/// most of its points go; new clusters are numbered after the others. Linear in points.
/// @param height of each point over the local ground, metres
void carveClusters(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const CarveConfig& config,
                   const CurvedVoxels& voxels,
                   Clusters& clusters);

}  // namespace segdf

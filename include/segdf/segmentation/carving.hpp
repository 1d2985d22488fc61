// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Makes clusters of their own of persons and bicycles (`config.person`, `config.bicycle`) that
/// stand free, as the sensor sees them, of the cluster that holds them. A cluster falls into pieces
/// where neighbours in the range image differ by more than `jump`. A piece is carved when it has
/// the size of its kind, lies in front of what is beside it, and nothing of its cluster goes on
/// beside or above it from the height of a chest up. What is no larger than a cyclist is left whole
/// unless it holds two. A voxel goes where most of its points go; what then has fewer than
/// `config.cvi.n_noise` points is noise; new clusters are numbered after the others. Linear in
/// points.
/// @param height of each point over the local ground, metres
void carveClusters(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const Config& config,
                   const CurvedVoxels& voxels,
                   Clusters& clusters);

}  // namespace segdf

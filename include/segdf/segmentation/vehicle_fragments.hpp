// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/cluster_shape.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Gives a cluster that may be a vehicle what lies behind its face, as the sensor sees it, and fits
/// into one vehicle with it: what is seen through its windows, and the lines on its far side that
/// are too far apart to be linked. That is noise, voxel by voxel, but not what is seen over its top
/// off its footprint; and whole clusters with few of its points (`config.fragment`) that are low
/// themselves (`config.fragment_height`). Of several vehicles the nearest gets it, then the first.
/// All is compared with the clusters as they were, so that the order does not matter. Clusters that
/// went into others stay empty.
/// @param height of each point over the local ground, metres
/// @param shapes of the clusters
void joinFragments(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const VehicleConfig& config,
                   const CurvedVoxels& voxels,
                   const std::vector<ClusterShape>& shapes,
                   Clusters& clusters);

}  // namespace segdf

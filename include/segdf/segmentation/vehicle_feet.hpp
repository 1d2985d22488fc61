// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/cluster_shape.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// Settles what is ground and what is foot of clusters that may be vehicles, by the plane through
/// the ground within 2 m (cells of 1 m), which is more exact than heights over cells. Their lowest
/// points become ground: road and kerb that the passes of object_feet.hpp gave them with their
/// wheels. Ground points in their footprint, `config.foot_rise` over the plane, become theirs. A
/// cluster of which more than `config.foot_share` is as low as ground, or more than a hundredth
/// lies deeper than `config.foot_depth`, does not stand on that plane and is left as it is. Voxels
/// follow (voxel_edit.hpp). Linear in points.
/// @param shapes of the clusters
void settleFeet(const std::vector<Point>& points,
                const VehicleConfig& config,
                const CurvedGrid& grid,
                const std::vector<ClusterShape>& shapes,
                std::vector<PointRole>& roles,
                CurvedVoxels& voxels,
                Clusters& clusters);

}  // namespace segdf

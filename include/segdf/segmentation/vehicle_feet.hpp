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

/// Makes ground of the lowest points of clusters that may be vehicles: road and kerb that the
/// passes of object_feet.hpp gave them with their wheels. Judged by the plane through the ground
/// within 2 m (cells of 1 m), which is more exact than heights over cells. A cluster of which more
/// than `config.foot_share` is that low, or more than a hundredth lies deeper than
/// `config.foot_depth`, does not stand on that plane and is left as it is. The points leave their
/// voxels, and voxels without points go; what is known of a voxel's intensity stays as it was.
/// Linear in points.
/// @param shapes of the clusters
void releaseGroundUnder(const std::vector<Point>& points,
                        const VehicleConfig& config,
                        const std::vector<ClusterShape>& shapes,
                        std::vector<PointRole>& roles,
                        CurvedVoxels& voxels,
                        Clusters& clusters);

}  // namespace segdf

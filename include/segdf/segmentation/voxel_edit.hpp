// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// A point that becomes one of a cluster.
struct AddedPoint {
  std::uint32_t point = 0;
  std::int32_t cluster = 0;
};

/// Takes out of the voxels what is no object point any more, and adds points. One that falls into a
/// voxel that there is goes where that belongs; a new voxel belongs to the cluster of its first
/// point. Voxels without points go. What is known of a voxel's intensity stays as it was, and is 0
/// for new ones. Linear in points.
void editVoxels(const std::vector<Point>& points,
                const std::vector<PointRole>& roles,
                const CurvedGrid& grid,
                const std::vector<AddedPoint>& added,
                CurvedVoxels& voxels,
                Clusters& clusters);

}  // namespace segdf

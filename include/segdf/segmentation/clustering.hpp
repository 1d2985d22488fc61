// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// Which cluster each voxel belongs to.
struct Clusters {
  static constexpr std::int32_t kNoise = -1;

  std::vector<std::int32_t> of_voxel;  ///< cluster, or kNoise
  std::size_t count = 0;               ///< clusters are 0..count-1, by smallest point index, those
                                       ///< carved off others last
};

/// Algorithm 1, lines 5-18, in the deterministic form of method.md 4.5: connected components under
/// the 27-neighbourhood with the chosen intensity gate, then merging of components that lie within
/// `ext` cells, are alike in intensity and together no larger than one movable object. Independent
/// of the order of points up to the numbering.
Clusters clusterVoxels(const std::vector<Point>& points,
                       const std::vector<float>& intensity,
                       const CurvedVoxels& voxels,
                       const CurvedGrid& grid,
                       const CurvedVoxelConfig& config);

/// The cluster of each point of the scan, kNoise for points in none.
std::vector<std::int32_t> clusterOfPoints(std::size_t points,
                                          const CurvedVoxels& voxels,
                                          const Clusters& clusters);

/// True iff a box is no larger than one movable object (condition s3 of method.md 4.5). Metres.
bool fitsMovableObject(const Eigen::AlignedBox3f& bounds, const CurvedVoxelConfig& config);

}  // namespace segdf

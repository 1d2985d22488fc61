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

/// Calls visit(cluster, point) for every point that is in a cluster, in the order of the voxels.
template <class Visit>
void forEachMember(const CurvedVoxels& voxels, const Clusters& clusters, const Visit& visit) {
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (clusters.of_voxel[v] == Clusters::kNoise) continue;
    const auto cluster = static_cast<std::size_t>(clusters.of_voxel[v]);
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      visit(cluster, voxels.points[k]);
    }
  }
}

/// Makes noise of clusters with fewer points, and closes the gaps in their numbers.
void dropSmallClusters(const CurvedVoxels& voxels, std::uint32_t n_noise, Clusters& clusters);

/// True iff a box is no larger than one movable object (condition s3 of method.md 4.5). Metres.
bool fitsMovableObject(const Eigen::AlignedBox3f& bounds, const CurvedVoxelConfig& config);

}  // namespace segdf

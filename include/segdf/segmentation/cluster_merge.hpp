// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/config.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

/// Sums over a component, kept at its root voxel.
struct ComponentSums {
  std::uint32_t points = 0;
  double intensity = 0.0;
  Eigen::AlignedBox3f bounds;

  double meanIntensity() const { return intensity / static_cast<double>(points); }
  void add(const ComponentSums& other) {
    points += other.points;
    intensity += other.intensity;
    bounds.extend(other.bounds);
  }
};

/// Stage 2 of Algorithm 1 (lines 12-18): unites components of `components` (roots are voxel ids) by
/// the strength condition of method.md 4.5. `sums` holds each component's sums at its root and is
/// kept up to date.
void mergeComponents(const CurvedVoxels& voxels,
                     const CurvedGrid& grid,
                     const CurvedVoxelConfig& config,
                     UnionFind& components,
                     std::vector<ComponentSums>& sums);

}  // namespace segdf

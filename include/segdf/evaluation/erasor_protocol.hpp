// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "segdf/evaluation/point_scores.hpp"
#include "segdf/evaluation/voxel_filter.hpp"

namespace segdf {

/// ERASOR's voxel-wise figures (peers.md 3.2, method.md 7.2).
struct VoxelScores {
  Share preserved;          ///< of the truth's static voxels
  Share remaining_dynamic;  ///< of the truth's dynamic voxels

  std::optional<double> preservationRate() const { return preserved.percent(); }  ///< PR, percent
  std::optional<double> rejectionRate() const;  ///< RR = 100 - what remains, percent
  std::optional<double> f1() const;             ///< harmonic mean of PR and RR, 0..1
};

/// Makes a map as ERASOR makes its truth: points of horizontal range under 2.7 m dropped, the rest
/// taken into the map frame and voxel-filtered scan by scan, accumulated and voxel-filtered again.
class VoxelMapBuilder {
 public:
  static constexpr double kLeaf = 0.2;      ///< metres
  static constexpr double kMinRange = 2.7;  ///< metres, horizontal

  /// True iff a point of a scan (sensor frame) takes part.
  static bool takes(const Eigen::Vector3f& in_sensor);
  /// @param scan one scan's points in the map frame
  void add(const ClassedPoints& scan) { accumulated_.append(voxelFilter(scan, kLeaf)); }
  ClassedPoints finish() const { return voxelFilter(accumulated_, kLeaf); }

 private:
  ClassedPoints accumulated_;
};

/// Both maps with voxels of VoxelMapBuilder::kLeaf. A voxel of the truth is an inlier iff the
/// estimate's nearest is less than half a voxel's diagonal away; static is every class but
/// 252..259.
VoxelScores compareVoxelMaps(const ClassedPoints& truth, const ClassedPoints& estimate);

/// Classes for the points of a map without labels: that of the nearest point of the truth, 0 when
/// there is none within 0.6 m. Further away no class can matter: a voxel that can be an inlier has
/// a point of the truth within half its diagonal plus the whole diagonal of the truth's voxel.
ClassedPoints transferClasses(const ClassedPoints& truth,
                              const std::vector<Eigen::Vector3f>& map,
                              int threads = 1);

}  // namespace segdf

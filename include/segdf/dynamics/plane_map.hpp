// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/dynamics/voxel_index.hpp"

namespace segdf {

/// Small plane of a scan, in its sensor frame.
struct SmallPlane {
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();     ///< metres
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit
};

/// The planes of a scan in voxels of 0.8 m: those of at least 6 points with a smallest eigenvalue
/// below 0.0025 m^2 (method.md 6.12, 1). What other scans are registered to.
class PlaneMap {
 public:
  PlaneMap() = default;
  PlaneMap(const std::vector<Point>& points, const std::vector<PointRole>& roles);

  /// Voxel of a place. Sensor frame, metres.
  std::uint64_t voxelOf(const Eigen::Vector3f& place) const { return voxels_.keyOf(place); }
  /// The plane of a voxel, nullptr when it has none.
  const SmallPlane* planeOf(std::uint64_t voxel) const {
    const std::int32_t plane = voxels_.find(voxel);
    return plane == VoxelIndex::kNone ? nullptr : &planes_[static_cast<std::size_t>(plane)];
  }
  std::size_t size() const { return planes_.size(); }

 private:
  static constexpr float kVoxel = 0.8F;  // metres

  // Of a scan's voxels few have a plane, and of the others nobody asks more than that.
  VoxelIndex voxels_{kVoxel};
  std::vector<SmallPlane> planes_;  // of each of them
};

/// Points that are registered to another scan's planes: the first in each cell of 1 m, of the
/// ground in each of 3 m (method.md 6.12, 1). Sensor frame, metres.
std::vector<Eigen::Vector3f> thinForRegistration(const std::vector<Point>& points,
                                                 const std::vector<PointRole>& roles);

}  // namespace segdf

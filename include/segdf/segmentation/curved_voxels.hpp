// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

/// The egocentric spherical grid of formula (7): cells in range, polar angle and azimuth. Azimuth
/// wraps exactly, because its step is rounded so that 360 degrees are a whole number of cells.
class CurvedGrid {
 public:
  /// One cell as a sortable number: range in the high bits, azimuth in the low ones.
  using Key = std::uint64_t;

  CurvedGrid(const CurvedVoxelConfig& config, double rho_min);

  /// Cell of a position in the sensor frame; nothing nearer than rho_min or not finite.
  std::optional<Key> keyOf(const Eigen::Vector3d& position) const {
    return keyOf(position, turnOf(position.y(), position.x()));
  }
  /// For who has its azimuth. @param turn turnOf(y, x)
  std::optional<Key> keyOf(const Eigen::Vector3d& position, double turn) const;

  int azimuthCells() const { return azimuth_cells_; }

  /// Key moved by whole cells in range and polar angle; azimuth as given, not wrapped.
  static Key shifted(Key key, int range_cells, int polar_cells, int azimuth_cells) {
    // Two's complement: adding a negative offset to the unsigned key subtracts it.
    const std::int64_t offset =
        static_cast<std::int64_t>(range_cells) * (std::int64_t{1} << (kPolarBits + kAzimuthBits)) +
        static_cast<std::int64_t>(polar_cells) * (std::int64_t{1} << kAzimuthBits) + azimuth_cells;
    return key + static_cast<Key>(offset);
  }
  static int azimuthOf(Key key) {
    return static_cast<int>(key & ((Key{1} << kAzimuthBits) - 1)) - static_cast<int>(kMargin);
  }

 private:
  // Key layout. Fields start at kMargin so that stepping down a few cells never borrows from the
  // next field.
  static constexpr unsigned kAzimuthBits = 14;
  static constexpr unsigned kPolarBits = 13;
  static constexpr std::int64_t kMargin = 8;

  double rangeCell(double rho) const;

  double rho_min_;
  double drho_;
  double growth_;
  double dtheta_;  // rad
  int azimuth_cells_;
};

using KeyedPoint = std::pair<CurvedGrid::Key, std::uint32_t>;

/// Sorts by key; points of equal key stay in their order. Linear (radix sort).
void sortByKey(std::vector<KeyedPoint>& items);

/// The table of Algorithm 1 line 4, Build-CVI: occupied cells in key order with the intensity
/// statistics AV and COV. A sorted array instead of a hash table, so that nothing depends on hash
/// order and neighbours are found by walking along it.
struct CurvedVoxels {
  std::vector<CurvedGrid::Key> keys;  ///< ascending, unique
  std::vector<std::uint32_t> begin;  ///< voxel v holds points[begin[v]] .. points[begin[v + 1] - 1]
  std::vector<std::uint32_t> points;  ///< indices into the scan
  std::vector<float> mean;            ///< AV: mean calibrated intensity
  std::vector<float> deviation;       ///< square root of COV, the population variance

  std::size_t size() const { return keys.size(); }
  std::uint32_t count(std::size_t voxel) const { return begin[voxel + 1] - begin[voxel]; }
};

/// @param items key and index of each point that takes part, in any order
/// @param intensity calibrated intensity of every point of the scan
CurvedVoxels buildCurvedVoxels(std::vector<KeyedPoint> items, const std::vector<float>& intensity);

/// Calls visit(q, v) for every query key q (index into `queries`, ascending and unique) and every
/// occupied voxel v within +-reach cells in range, polar angle and azimuth, the cell itself
/// included. Ordered by offset in range and polar angle, then q, then v. Linear in queries and
/// voxels.
template <class Visit>
void forEachNeighbour(const std::vector<CurvedGrid::Key>& queries,
                      const CurvedVoxels& voxels,
                      const CurvedGrid& grid,
                      int reach,
                      const Visit& visit);

/// Calls visit(a, b) once for every two occupied voxels a < b within +-reach cells of each other.
/// Ordered by offset in range and polar angle, then a, then b. Linear in voxels.
template <class Visit>
void forEachNeighbourPair(const CurvedVoxels& voxels,
                          const CurvedGrid& grid,
                          int reach,
                          const Visit& visit);

}  // namespace segdf

#include "segdf/segmentation/curved_voxels_neighbours.hpp"

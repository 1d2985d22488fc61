// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace segdf {

/// Points sorted into hashed cubic cells: neighbours within a few cell edges at a cost that does
/// not depend on the number of points. 16 bytes a point and 16 to 24 a cell.
class PointGrid {
 public:
  struct Neighbour {
    std::uint32_t index = 0;  ///< of the point in the list as it was given
    double distance = 0.0;    ///< metres
  };
  /// Points of one cell: positions [begin, end) of the sorted order.
  struct Cell {
    std::uint64_t key = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  /// @param points finite, at most 2^32 - 2; @param cell edge in metres, > 0
  /// @throws std::invalid_argument when one of these does not hold, or a point is further than 2^20
  /// cells from the origin along an axis
  PointGrid(const std::vector<Eigen::Vector3f>& points, double cell);

  std::size_t size() const { return points_.size(); }
  /// True iff a point lies within `radius` metres, inclusive.
  bool hasWithin(const Eigen::Vector3f& place, double radius) const;
  /// The nearest point within `radius` metres, inclusive; of several equally near ones the first
  /// that was given.
  std::optional<Neighbour> nearest(const Eigen::Vector3f& place, double radius) const;

  /// hasWithin for each place, 1 or 0, on up to `threads` threads.
  std::vector<std::uint8_t> haveWithin(const std::vector<Eigen::Vector3f>& places,
                                       double radius,
                                       int threads) const;

  /// Occupied cells, ordered by x, then y, then z; the points of a cell are in the order given.
  const std::vector<Cell>& cells() const { return cells_; }
  const Eigen::Vector3f& sortedPoint(std::size_t position) const { return points_[position]; }
  std::uint32_t indexOf(std::size_t position) const { return index_[position]; }

 private:
  using CellPlace = std::array<std::int64_t, 3>;

  CellPlace cellPlace(const Eigen::Vector3f& point) const;
  std::uint64_t keyOf(const CellPlace& place) const;
  /// Square of the distance from a place to the nearest point of a cell's cube.
  double squaredDistanceToCell(const Eigen::Vector3f& place, const CellPlace& cell) const;
  /// From a place in a cell to the nearest of the cell's faces.
  double distanceToFaces(const Eigen::Vector3f& place, const CellPlace& cell) const;
  const Cell* find(const CellPlace& place) const;
  void sort(const std::vector<Eigen::Vector3f>& points);
  void hashCells();

  double cell_;
  std::vector<Eigen::Vector3f> points_;
  std::vector<std::uint32_t> index_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> slots_;  ///< open addressing: position in cells_ + 1, 0 = free
  std::uint64_t mask_ = 0;
};

}  // namespace segdf

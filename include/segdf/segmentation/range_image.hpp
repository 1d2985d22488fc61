// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// Where each point lies in the sensor's grid: rows are lasers from the topmost (0) down, columns
/// are azimuth bins, wrapped (method.md 3.6).
class RangeImage {
 public:
  static constexpr std::int32_t kNone = -1;

  /// Rows come from the rings when every used point has one, else from the elevation between the
  /// configured bounds. Of several points in one cell the nearest is kept, then the first.
  RangeImage(const std::vector<Point>& points,
             const std::vector<PointRole>& roles,
             const RangeImageConfig& config);

  int rows() const { return rows_; }
  int columns() const { return columns_; }
  /// Row of a point, kNone for unused points.
  std::int32_t rowOf(std::size_t point) const { return row_[point]; }
  /// Column of a point, kNone for unused points.
  std::int32_t columnOf(std::size_t point) const { return column_[point]; }
  /// Index of the point seen in a cell, kNone when empty. The column is taken modulo columns().
  std::int32_t at(int row, int column) const {
    if (row < 0 || row >= rows_) return kNone;
    if (column < 0) column += columns_;
    if (column >= columns_) column -= columns_;
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }
  /// Columns or rows to look across for a neighbour: twice the columns between returns in the
  /// fullest row, 2 to 8. A sensor may have fewer columns than the image.
  int reach() const { return reach_; }
  /// First point within reach of a used one in a direction (one of the two is 0, the other 1 or
  /// -1), kNone when there is none.
  std::int32_t neighbourOf(std::size_t point, int down, int right) const {
    std::int32_t found = kNone;
    for (int step = 1; step <= reach_ && found == kNone; ++step) {
      found = at(row_[point] + down * step, column_[point] + right * step);
    }
    return found;
  }
  /// Azimuth of each point as a share of a full turn; anything for unused points.
  const std::vector<double>& turns() const { return turns_; }
  /// Distance of a point from the sensor, metres.
  float rangeOf(std::size_t point) const { return range_[point]; }

 private:
  void assignRows(const std::vector<Point>& points,
                  const std::vector<PointRole>& roles,
                  const RangeImageConfig& config);
  int measureReach() const;

  int rows_ = 0;
  int columns_ = 0;
  int reach_ = 0;
  std::vector<double> turns_;
  std::vector<std::int32_t> row_;
  std::vector<std::int32_t> column_;
  std::vector<float> range_;
  std::vector<std::int32_t> cells_;
};

/// Normals and change of curvature of the object points, from windows of 5 rows by 9 columns with a
/// gate in range; PCA over at least 6 neighbours (method.md 3.6). Made for every second column, of
/// which the points between have theirs: windows around neighbours hold nearly the same points.
std::vector<Surface> estimateSurfaces(const std::vector<Point>& points,
                                      const std::vector<PointRole>& roles,
                                      const RangeImage& image,
                                      const RangeImageConfig& config,
                                      int threads);

}  // namespace segdf

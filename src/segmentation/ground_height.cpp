// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "segdf/segmentation/ground.hpp"

namespace segdf {

namespace {

constexpr double kCell = 1.0;  // metres
constexpr int kFillCells = 8;
constexpr float kEmpty = std::numeric_limits<float>::quiet_NaN();

/// Square grid of ground heights around the sensor.
class HeightGrid {
 public:
  explicit HeightGrid(double reach)
      : side_(2 * static_cast<int>(std::ceil(reach / kCell)) + 1),
        cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), kEmpty),
        reached_(cells_.size(), 0) {}

  std::size_t size() const { return cells_.size(); }
  float operator[](std::size_t cell) const { return cells_[cell]; }
  void set(std::size_t cell, float height) { cells_[cell] = height; }

  /// Cell of a point, size() outside the grid.
  std::size_t cellOf(const Point& p) const {
    const int half = side_ / 2;
    const double ix = static_cast<double>(p.x) / kCell + half;
    const double iy = static_cast<double>(p.y) / kCell + half;
    // Not finite is in no interval either.
    if (!(ix >= 0 && iy >= 0 && ix < side_ && iy < side_)) return size();
    return index(static_cast<int>(ix), static_cast<int>(iy));
  }

  /// In each pass empty cells next to filled ones get the mean of those.
  void fill() {
    std::vector<std::size_t> filled;
    for (std::size_t cell = 0; cell < size(); ++cell) {
      if (!std::isnan(cells_[cell])) filled.push_back(cell);
    }
    for (int pass = 0; pass < kFillCells; ++pass) filled = grow(filled);
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(y);
  }

  template <class Visit>
  void forEachAround(std::size_t cell, const Visit& visit) const {
    const int x = static_cast<int>(cell / static_cast<std::size_t>(side_));
    const int y = static_cast<int>(cell % static_cast<std::size_t>(side_));
    for (int nx = std::max(0, x - 1); nx <= std::min(side_ - 1, x + 1); ++nx) {
      for (int ny = std::max(0, y - 1); ny <= std::min(side_ - 1, y + 1); ++ny) {
        visit(index(nx, ny));
      }
    }
  }

  /// Fills the cells around the last ones. @returns the newly filled
  std::vector<std::size_t> grow(const std::vector<std::size_t>& last) {
    std::vector<std::size_t> fresh;
    for (std::size_t cell : last) {
      forEachAround(cell, [&](std::size_t around) {
        if (!std::isnan(cells_[around]) || reached_[around] != 0) return;
        reached_[around] = 1;
        fresh.push_back(around);
      });
    }
    std::vector<float> heights;
    heights.reserve(fresh.size());
    for (std::size_t cell : fresh) heights.push_back(meanAround(cell));
    for (std::size_t k = 0; k < fresh.size(); ++k) cells_[fresh[k]] = heights[k];
    return fresh;
  }

  float meanAround(std::size_t cell) const {
    float sum = 0.0F;
    int count = 0;
    forEachAround(cell, [&](std::size_t around) {
      if (std::isnan(cells_[around])) return;
      sum += cells_[around];
      ++count;
    });
    return count > 0 ? sum / static_cast<float>(count) : kEmpty;
  }

  int side_;
  std::vector<float> cells_;
  std::vector<std::uint8_t> reached_;  ///< by filling
};

/// Median height of the ground points of each cell; the grid holds NaN where there is none.
void setMedians(const std::vector<Point>& points,
                const Ground& ground,
                const std::vector<std::uint32_t>& cell_of,
                HeightGrid& grid) {
  std::vector<std::uint32_t> begin(grid.size() + 2, 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ground.is_ground[i] != 0 && cell_of[i] < grid.size()) ++begin[cell_of[i] + 2];
  }
  for (std::size_t cell = 2; cell < begin.size(); ++cell) begin[cell] += begin[cell - 1];
  std::vector<float> heights(begin.back());
  // Filling moves begin[cell + 1] from the cell's first entry to its end.
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ground.is_ground[i] != 0 && cell_of[i] < grid.size()) {
      heights[begin[cell_of[i] + 1]++] = points[i].z;
    }
  }
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (begin[cell] == begin[cell + 1]) continue;
    const auto first = heights.begin() + static_cast<std::ptrdiff_t>(begin[cell]);
    const auto last = heights.begin() + static_cast<std::ptrdiff_t>(begin[cell + 1]);
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last);
    grid.set(cell, *middle);
  }
}

}  // namespace

std::vector<float> heightOverGround(const std::vector<Point>& points,
                                    const Ground& ground,
                                    double l_max) {
  HeightGrid grid(l_max);
  std::vector<std::uint32_t> cell_of(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    cell_of[i] = static_cast<std::uint32_t>(grid.cellOf(points[i]));
  setMedians(points, ground, cell_of, grid);
  grid.fill();
  const auto flat = static_cast<float>(-ground.sensor_height);
  std::vector<float> heights(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t cell = cell_of[i];
    const float level = cell < grid.size() && !std::isnan(grid[cell]) ? grid[cell] : flat;
    heights[i] = points[i].z - level;
  }
  return heights;
}

}  // namespace segdf

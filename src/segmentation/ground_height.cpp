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
        cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), kEmpty) {}

  std::size_t size() const { return cells_.size(); }
  float& operator[](std::size_t cell) { return cells_[cell]; }
  float operator[](std::size_t cell) const { return cells_[cell]; }

  /// Cell of a point, size() outside the grid.
  std::size_t cellOf(const Point& p) const {
    if (!isFinite(p)) return size();
    const double ix = std::floor(static_cast<double>(p.x) / kCell) + side_ / 2;
    const double iy = std::floor(static_cast<double>(p.y) / kCell) + side_ / 2;
    if (ix < 0 || iy < 0 || ix >= side_ || iy >= side_) return size();
    return index(static_cast<int>(ix), static_cast<int>(iy));
  }

  /// Each pass gives empty cells the mean of their filled neighbours.
  void fill() {
    for (int pass = 0; pass < kFillCells; ++pass) {
      const std::vector<float> before = cells_;
      for (int x = 0; x < side_; ++x) {
        for (int y = 0; y < side_; ++y) {
          if (std::isnan(before[index(x, y)])) cells_[index(x, y)] = meanAround(before, x, y);
        }
      }
    }
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(y);
  }

  float meanAround(const std::vector<float>& cells, int x, int y) const {
    float sum = 0.0F;
    int count = 0;
    for (int nx = std::max(0, x - 1); nx <= std::min(side_ - 1, x + 1); ++nx) {
      for (int ny = std::max(0, y - 1); ny <= std::min(side_ - 1, y + 1); ++ny) {
        const float value = cells[index(nx, ny)];
        if (std::isnan(value)) continue;
        sum += value;
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<float>(count) : kEmpty;
  }

  int side_;
  std::vector<float> cells_;
};

/// Median height of the ground points of each cell; the grid holds NaN where there is none.
void setMedians(const std::vector<Point>& points, const Ground& ground, HeightGrid& grid) {
  std::vector<std::pair<std::size_t, float>> samples;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ground.is_ground[i] == 0) continue;
    const std::size_t cell = grid.cellOf(points[i]);
    if (cell < grid.size()) samples.emplace_back(cell, points[i].z);
  }
  std::sort(samples.begin(), samples.end());
  for (std::size_t begin = 0; begin < samples.size();) {
    std::size_t end = begin;
    while (end < samples.size() && samples[end].first == samples[begin].first) ++end;
    grid[samples[begin].first] = samples[begin + (end - begin) / 2].second;
    begin = end;
  }
}

}  // namespace

std::vector<float> heightOverGround(const std::vector<Point>& points,
                                    const Ground& ground,
                                    double l_max) {
  HeightGrid grid(l_max);
  setMedians(points, ground, grid);
  grid.fill();
  const auto flat = static_cast<float>(-ground.sensor_height);
  std::vector<float> heights(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t cell = grid.cellOf(points[i]);
    const float level = cell < grid.size() && !std::isnan(grid[cell]) ? grid[cell] : flat;
    heights[i] = points[i].z - level;
  }
  return heights;
}

}  // namespace segdf

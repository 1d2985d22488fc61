// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/range_image.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;

double elevationDegrees(const Point& p) {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return arcTangent2(static_cast<double>(p.z), std::sqrt(x * x + y * y)) * 180.0 / kPi;
}

constexpr int kLeastReach = 2;
constexpr int kMostReach = 8;

// No sensor has more lasers; a field that says so holds something else.
constexpr std::int16_t kMaxRings = 256;

bool allHaveRings(const std::vector<Point>& points, const std::vector<PointRole>& roles) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool has_ring = points[i].ring >= 0 && points[i].ring < kMaxRings;
    if (roles[i] != PointRole::kUnused && !has_ring) return false;
  }
  return true;
}

/// Drivers count lasers from either end: rows are rings by falling mean sine of the elevation.
/// @returns row of each ring, kNone for rings without a point
std::vector<std::int32_t> rowsOfRings(const std::vector<Point>& points,
                                      const std::vector<PointRole>& roles,
                                      const std::vector<float>& range) {
  std::vector<std::pair<double, double>> sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const auto ring = static_cast<std::size_t>(points[i].ring);
    if (ring >= sums.size()) sums.resize(ring + 1);
    sums[ring].first += static_cast<double>(points[i].z / range[i]);
    sums[ring].second += 1.0;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t ring = 0; ring < sums.size(); ++ring) {
    if (sums[ring].second > 0.0) order.emplace_back(-sums[ring].first / sums[ring].second, ring);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> rows(sums.size(), RangeImage::kNone);
  for (std::size_t row = 0; row < order.size(); ++row) {
    rows[order[row].second] = static_cast<std::int32_t>(row);
  }
  return rows;
}

}  // namespace

RangeImage::RangeImage(const std::vector<Point>& points,
                       const std::vector<PointRole>& roles,
                       const RangeImageConfig& config)
    : rows_(config.beams),
      columns_(config.columns),
      turns_(turnsOf(points)),
      row_(points.size(), kNone),
      column_(points.size(), kNone),
      range_(points.size(), 0.0F) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] != PointRole::kUnused) range_[i] = points[i].position().norm();
  }
  assignRows(points, roles, config);
  cells_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    column_[i] = std::min(static_cast<std::int32_t>(turns_[i] * columns_), columns_ - 1);
    std::int32_t& cell =
        cells_[static_cast<std::size_t>(row_[i]) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column_[i])];
    if (cell == kNone || range_[i] < range_[static_cast<std::size_t>(cell)]) {
      cell = static_cast<std::int32_t>(i);
    }
  }
  reach_ = measureReach();
}

int RangeImage::measureReach() const {
  std::vector<int> returns(static_cast<std::size_t>(rows_), 0);
  int fullest = 1;
  for (std::int32_t row : row_) {
    if (row != kNone) fullest = std::max(fullest, ++returns[static_cast<std::size_t>(row)]);
  }
  return std::clamp((2 * columns_ + fullest / 2) / fullest, kLeastReach, kMostReach);
}

void RangeImage::assignRows(const std::vector<Point>& points,
                            const std::vector<PointRole>& roles,
                            const RangeImageConfig& config) {
  const bool by_ring = allHaveRings(points, roles);
  const std::vector<std::int32_t> rows =
      by_ring ? rowsOfRings(points, roles, range_) : std::vector<std::int32_t>{};
  for (std::int32_t row : rows) rows_ = std::max(rows_, row + 1);
  const double span = config.elevation_max - config.elevation_min;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    if (by_ring) {
      row_[i] = rows[static_cast<std::size_t>(points[i].ring)];
      continue;
    }
    const double from_top = (config.elevation_max - elevationDegrees(points[i])) / span;
    const double row = std::round(from_top * (rows_ - 1));
    row_[i] = static_cast<std::int32_t>(std::clamp(row, 0.0, static_cast<double>(rows_ - 1)));
  }
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/range_image.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;

double elevationDegrees(const Point& p) {
  return std::atan2(static_cast<double>(p.z),
                    std::hypot(static_cast<double>(p.x), static_cast<double>(p.y))) *
         180.0 / kPi;
}

bool allHaveRings(const std::vector<Point>& points, const std::vector<PointRole>& roles) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] != PointRole::kUnused && points[i].ring < 0) return false;
  }
  return true;
}

/// Drivers count lasers from either end: rows are rings by falling mean elevation.
std::map<std::int16_t, std::int32_t> rowsOfRings(const std::vector<Point>& points,
                                                 const std::vector<PointRole>& roles) {
  std::map<std::int16_t, std::pair<double, double>> sums;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    auto& sum = sums[points[i].ring];
    sum.first += elevationDegrees(points[i]);
    sum.second += 1.0;
  }
  std::vector<std::pair<double, std::int16_t>> order;
  for (const auto& [ring, sum] : sums) order.emplace_back(-sum.first / sum.second, ring);
  std::sort(order.begin(), order.end());
  std::map<std::int16_t, std::int32_t> rows;
  for (std::size_t row = 0; row < order.size(); ++row) {
    rows[order[row].second] = static_cast<std::int32_t>(row);
  }
  return rows;
}

std::int32_t columnOfAzimuth(const Point& p, int columns) {
  const double turn =
      std::atan2(static_cast<double>(p.y), static_cast<double>(p.x)) / (2.0 * kPi) + 0.5;
  return std::min(static_cast<std::int32_t>(turn * columns), columns - 1);
}

}  // namespace

RangeImage::RangeImage(const std::vector<Point>& points,
                       const std::vector<PointRole>& roles,
                       const RangeImageConfig& config)
    : rows_(config.beams),
      columns_(config.columns),
      row_(points.size(), kNone),
      column_(points.size(), kNone),
      range_(points.size(), 0.0F) {
  assignRows(points, roles, config);
  cells_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    range_[i] = points[i].position().norm();
    column_[i] = columnOfAzimuth(points[i], columns_);
    std::int32_t& cell =
        cells_[static_cast<std::size_t>(row_[i]) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column_[i])];
    if (cell == kNone || range_[i] < range_[static_cast<std::size_t>(cell)]) {
      cell = static_cast<std::int32_t>(i);
    }
  }
}

void RangeImage::assignRows(const std::vector<Point>& points,
                            const std::vector<PointRole>& roles,
                            const RangeImageConfig& config) {
  const bool by_ring = allHaveRings(points, roles);
  const auto rows = by_ring ? rowsOfRings(points, roles) : std::map<std::int16_t, std::int32_t>{};
  rows_ = std::max(rows_, static_cast<int>(rows.size()));
  const double span = config.elevation_max - config.elevation_min;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    if (by_ring) {
      row_[i] = rows.at(points[i].ring);
      continue;
    }
    const double from_top = (config.elevation_max - elevationDegrees(points[i])) / span;
    const double row = std::round(from_top * (rows_ - 1));
    row_[i] = static_cast<std::int32_t>(std::clamp(row, 0.0, static_cast<double>(rows_ - 1)));
  }
}

std::int32_t RangeImage::at(int row, int column) const {
  if (row < 0 || row >= rows_) return kNone;
  if (column < 0) column += columns_;
  if (column >= columns_) column -= columns_;
  return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                static_cast<std::size_t>(column)];
}

}  // namespace segdf

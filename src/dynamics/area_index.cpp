// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/area_index.hpp"

#include <algorithm>
#include <cstddef>

namespace segdf {

AreaIndex::AreaIndex(const std::vector<Point>& points, const std::vector<PointRole>& roles)
    : points_(points), begin_(kSide * kSide + 1, 0) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] != PointRole::kUnused) ++begin_[cellOf(points[i]) + 1];
  }
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  order_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    order_[next[cellOf(points[i])]++] = static_cast<std::uint32_t>(i);
  }
}

int AreaIndex::cellAt(float coordinate) {
  constexpr int kHalf = kSide / 2;
  const float cell = coordinate / kCell + static_cast<float>(kHalf);
  return static_cast<int>(std::clamp(cell, 0.0F, static_cast<float>(kSide - 1)));
}

std::size_t AreaIndex::cellOf(const Point& p) {
  return static_cast<std::size_t>(cellAt(p.y)) * kSide + static_cast<std::size_t>(cellAt(p.x));
}

std::vector<std::uint32_t> AreaIndex::pointsIn(const Eigen::AlignedBox2f& area) const {
  std::vector<std::uint32_t> found;
  const auto first = static_cast<std::size_t>(cellAt(area.min().x()));
  const auto last = static_cast<std::size_t>(cellAt(area.max().x()));
  for (int row = cellAt(area.min().y()); row <= cellAt(area.max().y()); ++row) {
    const std::size_t cell = static_cast<std::size_t>(row) * kSide;
    for (std::uint32_t k = begin_[cell + first]; k < begin_[cell + last + 1]; ++k) {
      const Point& p = points_[order_[k]];
      if (area.contains(p.position().head<2>())) found.push_back(order_[k]);
    }
  }
  return found;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>

#include "segdf/segmentation/ground.hpp"

namespace segdf {

namespace {

// Far enough to see ground under any mounting, near enough that slope does not matter.
constexpr double kReach = 10.0;
constexpr std::size_t kCells = 72;
constexpr std::size_t kMinPoints = 10;
constexpr double kLowQuantile = 0.1;

}  // namespace

double estimateSensorHeight(const std::vector<Point>& points,
                            const std::vector<PointRole>& roles,
                            const std::vector<double>& turns,
                            const GroundConfig& config) {
  std::vector<std::vector<float>> cells(kCells);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const auto x = static_cast<double>(points[i].x);
    const auto y = static_cast<double>(points[i].y);
    const double square = x * x + y * y;
    if (square <= config.l_min * config.l_min || square > kReach * kReach) continue;
    cells[std::min(static_cast<std::size_t>(turns[i] * kCells), kCells - 1)].push_back(points[i].z);
  }
  std::vector<double> lows;
  for (auto& cell : cells) {
    if (cell.size() < kMinPoints) continue;
    const auto low = static_cast<std::ptrdiff_t>(kLowQuantile * static_cast<double>(cell.size()));
    std::nth_element(cell.begin(), cell.begin() + low, cell.end());
    lows.push_back(static_cast<double>(cell[static_cast<std::size_t>(low)]));
  }
  if (lows.empty()) return 0.0;
  const auto middle = lows.begin() + static_cast<std::ptrdiff_t>(lows.size() / 2);
  std::nth_element(lows.begin(), middle, lows.end());
  return std::max(0.0, -*middle);
}

}  // namespace segdf

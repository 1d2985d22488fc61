// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/curved_voxels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;

// 2^20 range cells: 10 km at the smallest step; farther points share the last cell.
constexpr double kMaxRangeCell = 1048575.0;

constexpr unsigned kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

/// Moves `items` into order of the digit at `shift`.
void sortDigit(std::vector<KeyedPoint>& items, std::vector<KeyedPoint>& scratch, unsigned shift) {
  std::array<std::size_t, kDigits + 1> start{};
  const auto digit = [shift](const KeyedPoint& item) {
    return static_cast<std::size_t>((item.first >> shift) & (kDigits - 1));
  };
  for (const KeyedPoint& item : items) ++start[digit(item) + 1];
  for (std::size_t d = 0; d < kDigits; ++d) start[d + 1] += start[d];
  for (const KeyedPoint& item : items) scratch[start[digit(item)]++] = item;
  items.swap(scratch);
}

}  // namespace

CurvedGrid::CurvedGrid(const CurvedVoxelConfig& config, double rho_min)
    : rho_min_(rho_min),
      drho_(config.drho),
      growth_(config.growth),
      dtheta_(config.dtheta * kPi / 180.0),
      azimuth_cells_(static_cast<int>(std::lround(360.0 / config.dphi))) {}

double CurvedGrid::rangeCell(double rho) const {
  const double way = rho - rho_min_;
  if (growth_ <= 0.0) return std::floor(way / drho_);
  // Cell n is drho + growth * n wide: border n lies at drho n + growth n (n - 1) / 2.
  const double b = drho_ - growth_ / 2.0;
  return std::floor((std::sqrt(b * b + 2.0 * growth_ * way) - b) / growth_);
}

std::optional<CurvedGrid::Key> CurvedGrid::keyOf(const Eigen::Vector3d& position,
                                                 double turn) const {
  const double horizontal = position.head<2>().squaredNorm();
  const double rho = std::sqrt(horizontal + position.z() * position.z());
  if (!(rho >= rho_min_) || !std::isfinite(rho) || rho <= 0.0) return std::nullopt;
  const double theta = arcTangent2(std::sqrt(horizontal), position.z());
  const auto i = static_cast<std::int64_t>(std::min(rangeCell(rho), kMaxRangeCell));
  const auto j = static_cast<std::int64_t>(theta / dtheta_);
  const auto k = std::min(static_cast<std::int64_t>(turn * azimuth_cells_),
                          static_cast<std::int64_t>(azimuth_cells_ - 1));
  return (static_cast<Key>(i + kMargin) << (kPolarBits + kAzimuthBits)) |
         (static_cast<Key>(j + kMargin) << kAzimuthBits) | static_cast<Key>(k + kMargin);
}

void sortByKey(std::vector<KeyedPoint>& items) {
  CurvedGrid::Key used = 0;
  for (const KeyedPoint& item : items) used |= item.first;
  std::vector<KeyedPoint> scratch(items.size());
  for (unsigned shift = 0; shift < 64 && (used >> shift) != 0; shift += kDigitBits) {
    sortDigit(items, scratch, shift);
  }
}

CurvedVoxels buildCurvedVoxels(std::vector<KeyedPoint> items, const std::vector<float>& intensity) {
  sortByKey(items);
  CurvedVoxels voxels;
  voxels.points.reserve(items.size());
  for (std::size_t first = 0; first < items.size();) {
    std::size_t last = first;
    double sum = 0.0;
    double squares = 0.0;
    for (; last < items.size() && items[last].first == items[first].first; ++last) {
      const auto value = static_cast<double>(intensity[items[last].second]);
      sum += value;
      squares += value * value;
      voxels.points.push_back(items[last].second);
    }
    const auto n = static_cast<double>(last - first);
    const double mean = sum / n;
    voxels.keys.push_back(items[first].first);
    voxels.begin.push_back(static_cast<std::uint32_t>(first));
    voxels.mean.push_back(static_cast<float>(mean));
    voxels.deviation.push_back(
        static_cast<float>(std::sqrt(std::max(0.0, squares / n - mean * mean))));
    first = last;
  }
  voxels.begin.push_back(static_cast<std::uint32_t>(items.size()));
  return voxels;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/curved_voxels.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr double kPi = 3.14159265358979323846;

Eigen::Vector3d spherical(double rho, double theta_deg, double phi_deg) {
  const double theta = theta_deg * kPi / 180.0;
  const double phi = phi_deg * kPi / 180.0;
  return {rho * std::sin(theta) * std::cos(phi), rho * std::sin(theta) * std::sin(phi),
          rho * std::cos(theta)};
}

CurvedVoxelConfig coarse() {
  CurvedVoxelConfig config;
  config.drho = 1.0;
  config.dtheta = 10.0;
  config.dphi = 30.0;
  return config;
}

/// (i, j, k) of (7) worked out directly.
std::tuple<int, int, int> cell(const Eigen::Vector3d& x,
                               const CurvedVoxelConfig& config,
                               double rho_min) {
  const double rho = x.norm();
  double phi = std::atan2(x.y(), x.x()) * 180.0 / kPi;
  if (phi < 0.0) phi += 360.0;
  return {static_cast<int>((rho - rho_min) / config.drho),
          static_cast<int>(std::acos(x.z() / rho) * 180.0 / kPi / config.dtheta),
          static_cast<int>(phi / config.dphi)};
}

TEST(CurvedGrid, CellsAreThoseOfFormula7) {
  const CurvedGrid grid(coarse(), 1.0);
  const auto base = grid.keyOf(spherical(5.5, 95.0, 45.0));
  ASSERT_TRUE(base);
  EXPECT_EQ(grid.keyOf(spherical(6.5, 95.0, 45.0)), CurvedGrid::shifted(*base, 1, 0, 0));
  EXPECT_EQ(grid.keyOf(spherical(5.5, 105.0, 45.0)), CurvedGrid::shifted(*base, 0, 1, 0));
  EXPECT_EQ(grid.keyOf(spherical(5.5, 95.0, 75.0)), CurvedGrid::shifted(*base, 0, 0, 1));
  EXPECT_EQ(grid.keyOf(spherical(5.9, 99.0, 59.0)), base);
}

TEST(CurvedGrid, TooNearOrNotFiniteHasNoCell) {
  const CurvedGrid grid(coarse(), 1.0);
  EXPECT_FALSE(grid.keyOf(spherical(0.9, 90.0, 0.0)));
  EXPECT_FALSE(grid.keyOf({0.0, 0.0, 0.0}));
  EXPECT_FALSE(grid.keyOf({std::nan(""), 1.0, 1.0}));
  EXPECT_FALSE(grid.keyOf({std::numeric_limits<double>::infinity(), 1.0, 1.0}));
}

TEST(CurvedGrid, AzimuthStepIsRoundedToAWholeTurn) {
  CurvedVoxelConfig config;
  config.dphi = 0.7;
  EXPECT_EQ(CurvedGrid(config, 1.0).azimuthCells(), 514);
}

TEST(CurvedGrid, GrowingCellsHaveTheWidthsAsked) {
  CurvedVoxelConfig config = coarse();
  config.growth = 0.1;  // widths 1.0, 1.1, 1.2, ...: borders at 1, 2, 3.1, 4.3 m
  const CurvedGrid grid(config, 1.0);
  const auto first = grid.keyOf(spherical(1.5, 90.0, 10.0));
  ASSERT_TRUE(first);
  EXPECT_EQ(grid.keyOf(spherical(2.01, 90.0, 10.0)), CurvedGrid::shifted(*first, 1, 0, 0));
  EXPECT_EQ(grid.keyOf(spherical(3.09, 90.0, 10.0)), CurvedGrid::shifted(*first, 1, 0, 0));
  EXPECT_EQ(grid.keyOf(spherical(3.11, 90.0, 10.0)), CurvedGrid::shifted(*first, 2, 0, 0));
  EXPECT_EQ(grid.keyOf(spherical(4.31, 90.0, 10.0)), CurvedGrid::shifted(*first, 3, 0, 0));
}

TEST(SortByKey, EqualsAStableSort) {
  std::mt19937_64 generator(11);
  std::vector<KeyedPoint> items;
  for (std::uint32_t i = 0; i < 5000; ++i) items.emplace_back(generator() % 700 << 20U, i);
  std::vector<KeyedPoint> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  sortByKey(items);
  EXPECT_EQ(items, expected);
}

TEST(CurvedVoxels, MeanAndDeviationOfIntensity) {
  const std::vector<float> intensity{0.2F, 0.9F, 0.4F, 0.6F};
  const CurvedVoxels voxels = buildCurvedVoxels({{5, 0}, {9, 1}, {5, 2}, {5, 3}}, intensity);
  ASSERT_EQ(voxels.size(), 2U);
  EXPECT_EQ(voxels.count(0), 3U);
  EXPECT_NEAR(voxels.mean[0], 0.4, 1e-6);
  EXPECT_NEAR(voxels.deviation[0], std::sqrt(0.08 / 3.0), 1e-6);  // population variance
  EXPECT_NEAR(voxels.deviation[1], 0.0, 1e-4);
}

/// Neighbours found by the walk equal those found by comparing all cells with all cells, seam
/// included.
TEST(CurvedVoxels, NeighboursEqualBruteForce) {
  const CurvedVoxelConfig config = coarse();
  const CurvedGrid grid(config, 0.0);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-6.0, 6.0);
  std::vector<KeyedPoint> items;
  std::vector<std::tuple<int, int, int>> cells;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Eigen::Vector3d x(uniform(generator), uniform(generator), uniform(generator));
    items.emplace_back(*grid.keyOf(x), i);
    cells.push_back(cell(x, config, 0.0));
  }
  const CurvedVoxels voxels = buildCurvedVoxels(items, std::vector<float>(300, 0.0F));
  for (int reach : {1, 2}) {
    std::multiset<std::pair<std::size_t, std::size_t>> found;
    forEachNeighbour(voxels.keys, voxels, grid, reach,
                     [&](std::size_t q, std::size_t v) { found.emplace(q, v); });
    std::multiset<std::pair<std::size_t, std::size_t>> expected;
    for (std::size_t q = 0; q < voxels.size(); ++q) {
      for (std::size_t v = 0; v < voxels.size(); ++v) {
        const auto [i1, j1, k1] = cells[voxels.points[voxels.begin[q]]];
        const auto [i2, j2, k2] = cells[voxels.points[voxels.begin[v]]];
        const int around = std::abs(k1 - k2);
        const bool near = std::abs(i1 - i2) <= reach && std::abs(j1 - j2) <= reach &&
                          std::min(around, 12 - around) <= reach;
        if (near) expected.emplace(q, v);
      }
    }
    EXPECT_EQ(found, expected) << "reach " << reach;
  }
}

}  // namespace
}  // namespace segdf

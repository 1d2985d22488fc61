// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/point_grid.hpp"

#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace segdf {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Points randomPoints(std::size_t count, float half, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-half, half);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = uniform(random);
    const float y = uniform(random);
    points.emplace_back(x, y, uniform(random));
  }
  return points;
}

std::optional<PointGrid::Neighbour> bruteForce(const Points& points,
                                               const Eigen::Vector3f& place,
                                               double radius) {
  std::optional<PointGrid::Neighbour> best;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double distance = (points[i].cast<double>() - place.cast<double>()).norm();
    if (distance <= radius && (!best || distance < best->distance)) best = {i, distance};
  }
  return best;
}

TEST(PointGrid, AgreesWithBruteForce) {
  const Points points = randomPoints(2000, 1.5F, 1);
  const PointGrid grid(points, 0.2);
  std::size_t found_count = 0;
  for (const Eigen::Vector3f& place : randomPoints(500, 2.0F, 2)) {
    for (const double radius : {0.05, 0.2, 0.65}) {
      const auto expected = bruteForce(points, place, radius);
      const auto found = grid.nearest(place, radius);
      ASSERT_EQ(found.has_value(), expected.has_value());
      EXPECT_EQ(grid.hasWithin(place, radius), expected.has_value());
      if (!found) continue;
      ++found_count;
      EXPECT_EQ(found->index, expected->index);
      EXPECT_DOUBLE_EQ(found->distance, expected->distance);
    }
  }
  EXPECT_GT(found_count, 300U) << "the test would be empty";
  EXPECT_LT(found_count, 1400U);
}

TEST(PointGrid, TheRadiusIsInclusive) {
  const PointGrid grid({{0.5F, 0.0F, 0.0F}}, 0.25);
  EXPECT_TRUE(grid.hasWithin({0.0F, 0.0F, 0.0F}, 0.5));
  EXPECT_TRUE(grid.nearest({0.0F, 0.0F, 0.0F}, 0.5));
  EXPECT_FALSE(grid.hasWithin({-0.001F, 0.0F, 0.0F}, 0.5));
}

TEST(PointGrid, OfEquallyNearPointsTheFirstGivenIsFound) {
  const PointGrid grid({{1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}, 0.4);
  EXPECT_EQ(grid.nearest({0.0F, 0.0F, 0.0F}, 2.0)->index, 0U);
}

TEST(PointGrid, CellsHoldEveryPointOnceInOrder) {
  const Points points{{0.9F, 0.0F, 0.0F}, {-0.1F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}};
  const PointGrid grid(points, 1.0);
  ASSERT_EQ(grid.cells().size(), 2U);
  EXPECT_EQ(grid.indexOf(grid.cells()[0].begin), 1U) << "below 0 is another cell";
  EXPECT_EQ(grid.indexOf(grid.cells()[1].begin), 0U);
  EXPECT_EQ(grid.indexOf(grid.cells()[1].begin + 1), 2U);
  EXPECT_EQ(grid.cells()[1].end, 3U);
}

TEST(PointGrid, AnEmptyGridHasNoNeighbours) {
  const PointGrid grid({}, 0.1);
  EXPECT_FALSE(grid.hasWithin({0.0F, 0.0F, 0.0F}, 1.0));
  EXPECT_FALSE(grid.nearest({0.0F, 0.0F, 0.0F}, 1.0));
}

TEST(PointGrid, BadInputThrows) {
  EXPECT_THROW(PointGrid({}, 0.0), std::invalid_argument);
  EXPECT_THROW(PointGrid({{std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F}}, 0.1),
               std::invalid_argument);
  EXPECT_THROW(PointGrid({{1e6F, 0.0F, 0.0F}}, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/area_index.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace segdf {
namespace {

// As far as a sensor sees and farther: what is beyond the cells is found all the same.
TEST(AreaIndex, FindsWhatAWalkOverAllPointsFinds) {
  std::mt19937 random(7);
  std::normal_distribution<float> place(0.0F, 80.0F);
  std::vector<Point> points(5000);
  std::vector<PointRole> roles(points.size(), PointRole::kObject);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].x = place(random);
    points[i].y = place(random);
    if (i % 10 == 0) roles[i] = PointRole::kUnused;
  }
  const AreaIndex index(points, roles);
  std::size_t found = 0;
  for (int k = 0; k < 200; ++k) {
    Eigen::AlignedBox2f area(Eigen::Vector2f(place(random), place(random)));
    area.extend(Eigen::Vector2f(place(random), place(random)));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      const bool inside = area.contains(points[i].position().head<2>());
      if (inside && roles[i] != PointRole::kUnused) expected.push_back(i);
    }
    std::vector<std::uint32_t> points_in = index.pointsIn(area);
    std::sort(points_in.begin(), points_in.end());
    ASSERT_EQ(points_in, expected) << "area " << k;
    found += expected.size();
  }
  EXPECT_GT(found, 10000U) << "areas that hold next to nothing prove nothing";
}

TEST(AreaIndex, OfNothingHoldsNothing) {
  const std::vector<Point> points;
  const AreaIndex index(points, {});
  EXPECT_TRUE(index.pointsIn({Eigen::Vector2f(-5.0F, -5.0F), Eigen::Vector2f(5.0F, 5.0F)}).empty());
}

}  // namespace
}  // namespace segdf

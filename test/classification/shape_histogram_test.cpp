// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/shape_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <pcl/features/esf.h>
#include <pcl/point_types.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

ShapeHistogram describe(const std::vector<Point>& points) {
  std::vector<std::uint32_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0U);
  return shapeHistogram(points, indices);
}

ShapeHistogram describeByPcl(const std::vector<Point>& points) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Point& p : points) cloud->push_back({p.x, p.y, p.z});
  pcl::ESFEstimation<pcl::PointXYZ, pcl::ESFSignature640> estimation;
  estimation.setInputCloud(cloud);
  pcl::PointCloud<pcl::ESFSignature640> result;
  estimation.compute(result);
  ShapeHistogram histogram;
  std::copy_n(result.front().histogram, histogram.bins.size(), histogram.bins.begin());
  return histogram;
}

std::vector<Point> car() {
  auto side = test::randomBlob({10, 0, 0.7}, {4.0, 0.05, 1.3}, 500, 1);
  const auto back = test::randomBlob({12, 0.8, 0.7}, {0.05, 1.6, 1.3}, 300, 2);
  side.insert(side.end(), back.begin(), back.end());
  return side;
}

std::vector<Point> person() { return test::randomBlob({8, 0, 0.9}, {0.4, 0.5, 1.8}, 300, 3); }
std::vector<Point> wall() { return test::randomBlob({9, 0, 1.5}, {8.0, 0.05, 3.0}, 900, 4); }

TEST(ShapeHistogram, BinsSumUpToOne) {
  const ShapeHistogram histogram = describe(car());
  ASSERT_TRUE(histogram.valid);
  EXPECT_NEAR(std::accumulate(histogram.bins.begin(), histogram.bins.end(), 0.0), 1.0, 1e-4);
  const auto pooled = histogram.pooled();
  EXPECT_EQ(pooled.size(), 90U);
  EXPECT_NEAR(std::accumulate(pooled.begin(), pooled.end(), 0.0), 1.0, 1e-4);
}

TEST(ShapeHistogram, OrderOfPointsDoesNotMatter) {
  std::vector<Point> points = car();
  const ShapeHistogram straight = describe(points);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(straight.bins, describe(points).bins);
}

/// PCL's own two runs differ by 0.04 to 0.07 (it draws by the clock); pooled, ours must stay within
/// a few times that, and shapes that differ must be farther apart than the two ways of counting.
TEST(ShapeHistogram, AgreesWithPcl) {
  const std::vector<std::vector<Point>> shapes{car(), person(), wall()};
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    const auto ours = describe(shapes[k]).pooled();
    const float same = distance(ours, describeByPcl(shapes[k]).pooled());
    EXPECT_LT(same, 0.3F) << "shape " << k;
    for (std::size_t other = 0; other < shapes.size(); ++other) {
      if (other == k) continue;
      EXPECT_LT(same, distance(ours, describeByPcl(shapes[other]).pooled())) << k << ' ' << other;
    }
  }
}

/// PCL's version never returns on some of these.
TEST(ShapeHistogram, DegenerateClustersReturnAndAreNotValid) {
  const Point p{5.0F, 1.0F, 0.5F, 0.1F, 0.0F, -1};
  EXPECT_FALSE(describe({}).valid);
  EXPECT_FALSE(describe({p, p, p}).valid);
  EXPECT_FALSE(describe(std::vector<Point>(100, p)).valid);
  std::vector<Point> line(100, p);
  for (std::size_t i = 0; i < line.size(); ++i) line[i].x = static_cast<float>(i);
  EXPECT_FALSE(describe(line).valid);
  for (float value : describe(line).bins) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace segdf

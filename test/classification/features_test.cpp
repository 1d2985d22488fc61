// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/features.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

/// Describes all points as one segment; heights are z, laser and column follow from the index.
Segment describe(const std::vector<Point>& points) {
  std::vector<float> height;
  std::vector<std::int32_t> row(points.size(), 10);
  std::vector<std::int32_t> column(points.size());
  std::iota(column.begin(), column.end(), 0);
  for (const Point& p : points) height.push_back(p.z);
  const std::vector<Surface> surfaces(points.size());
  Segment segment;
  segment.points.resize(points.size());
  std::iota(segment.points.begin(), segment.points.end(), 0U);
  describeSegment({points, height, row, column, surfaces}, segment);
  return segment;
}

void expectFinite(const Segment& segment, const char* what) {
  for (float value : segment.features.values) EXPECT_TRUE(std::isfinite(value)) << what;
}

TEST(Features, ABoxHasItsSizeAndHeading) {
  std::vector<Point> points = test::randomBlob({0, 0, 0.75}, {4.0, 1.6, 1.5}, 4000, 1);
  const Eigen::AngleAxisf turn(0.5236F,
                               Eigen::Vector3f::UnitZ());  // 30 degrees: on the 3 degree grid
  for (Point& p : points) {
    const Eigen::Vector3f x = turn * p.position() + Eigen::Vector3f(20.0F, 5.0F, 0.0F);
    p.x = x.x();
    p.y = x.y();
  }
  const Segment segment = describe(points);
  EXPECT_NEAR(segment.box.size.x(), 4.0F, 0.05F);
  EXPECT_NEAR(segment.box.size.y(), 1.6F, 0.05F);
  EXPECT_NEAR(segment.box.yaw, 0.5236F, 0.03F);
  EXPECT_NEAR(segment.box.center.x(), 20.0F, 0.03F);
  EXPECT_NEAR(segment.features[Feature::kLength], 4.0F, 0.05F);
  EXPECT_NEAR(segment.features[Feature::kTop], 0.98F * 1.5F, 0.02F);
  EXPECT_NEAR(segment.features[Feature::kBottom], 0.02F * 1.5F, 0.02F);
  EXPECT_NEAR(segment.features[Feature::kLogCount], std::log10(4000.0F), 1e-4F);
}

TEST(Features, LinePlaneAndBallAreLinearPlanarAndScattered) {
  const Segment line = describe(test::randomBlob({10, 0, 0}, {6.0, 0.001, 0.001}, 500, 2));
  EXPECT_GT(line.features[Feature::kLinearity], 0.99F);
  const Segment plane = describe(test::randomBlob({10, 0, 0}, {4.0, 4.0, 0.001}, 2000, 3));
  EXPECT_GT(plane.features[Feature::kPlanarity], 0.9F);
  EXPECT_LT(plane.features[Feature::kVerticality], 0.01F);
  const Segment ball = describe(test::randomBlob({10, 0, 0}, {2.0, 2.0, 2.0}, 4000, 4));
  EXPECT_GT(ball.features[Feature::kScattering], 0.9F);
  EXPECT_NEAR(ball.features[Feature::kEigenentropy], std::log(3.0F), 0.01F);
}

TEST(Features, VerticalWallStandsUpright) {
  const Segment wall = describe(test::randomBlob({10, 0, 1.5}, {8.0, 0.02, 3.0}, 3000, 5));
  EXPECT_GT(wall.features[Feature::kVerticality], 0.99F);
  EXPECT_LT(wall.features[Feature::kWidth], 0.1F);
}

TEST(Features, DegenerateClustersAreFinite) {
  const Point p{5.0F, 1.0F, 0.5F, 0.1F, 0.0F, -1};
  const Point q{6.0F, 1.0F, 0.5F, 0.1F, 0.0F, -1};
  const Point r{7.0F, 1.0F, 0.5F, 0.1F, 0.0F, -1};
  expectFinite(describe({}), "none");
  expectFinite(describe({p}), "one");
  expectFinite(describe({p, q}), "two");
  expectFinite(describe({p, q, r}), "collinear");
  expectFinite(describe(std::vector<Point>(50, p)), "coincident");
  EXPECT_EQ(describe(std::vector<Point>(50, p)).features[Feature::kLinearity], 0.0F);
}

TEST(Features, TopcutIsTheShareOfColumnsThatEndInTheTopLasers) {
  const auto points = test::randomBlob({10, 0, 1}, {1, 1, 1}, 100, 6);
  const std::vector<float> height(100, 1.0F);
  std::vector<std::int32_t> column(100);
  std::vector<std::int32_t> row(100, 20);
  for (std::int32_t i = 0; i < 100; ++i) column[static_cast<std::size_t>(i)] = i / 10;
  for (std::size_t i = 0; i < 30; i += 10) row[i] = 2;  // three of ten columns reach the top
  row[95] = 3;  // the fourth laser is not one of the top three
  Segment segment;
  segment.points.resize(100);
  std::iota(segment.points.begin(), segment.points.end(), 0U);
  describeSegment({points, height, row, column, std::vector<Surface>(100)}, segment);
  EXPECT_FLOAT_EQ(segment.features[Feature::kTopcut], 0.3F);
  EXPECT_FLOAT_EQ(segment.features[Feature::kGroundContact], 0.0F);
}

TEST(Features, LocalSharesCountOnlyWhatIsKnown) {
  const auto points = test::randomBlob({10, 0, 1}, {1, 1, 1}, 4, 7);
  std::vector<Surface> surfaces(4);
  surfaces[0] = {Eigen::Vector3f::UnitX(), 0.01F};
  surfaces[1] = {Eigen::Vector3f::UnitZ(), 0.03F};
  surfaces[2] = {Eigen::Vector3f::Zero(), 0.20F};
  Segment segment;
  segment.points = {0, 1, 2, 3};
  const std::vector<float> height(4, 0.0F);
  const std::vector<std::int32_t> cells(4, 5);
  describeSegment({points, height, cells, cells, surfaces}, segment);
  EXPECT_FLOAT_EQ(segment.features[Feature::kVerticalShare], 0.5F);
  EXPECT_FLOAT_EQ(segment.features[Feature::kSmoothShare], 1.0F / 3.0F);
  EXPECT_FLOAT_EQ(segment.features[Feature::kLocalCurvature], 0.08F);
}

TEST(Features, RoughnessIsTheMedianOfWhatIsKnownOfTenPointsOrMore) {
  const auto points = test::randomBlob({10, 0, 1}, {1, 1, 1}, 20, 8);
  std::vector<Surface> surfaces(points.size());
  for (std::size_t i = 0; i < 9; ++i) surfaces[i].roughness = 0.01F * static_cast<float>(i);
  Segment segment;
  segment.points.resize(points.size());
  std::iota(segment.points.begin(), segment.points.end(), 0U);
  const std::vector<float> height(points.size(), 0.0F);
  const std::vector<std::int32_t> cells(points.size(), 5);
  describeSegment({points, height, cells, cells, surfaces}, segment);
  EXPECT_EQ(segment.features[Feature::kRoughness], 0.0F);
  surfaces[9].roughness = 5.0F;
  describeSegment({points, height, cells, cells, surfaces}, segment);
  EXPECT_FLOAT_EQ(segment.features[Feature::kRoughness], 0.05F);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/range_image.hpp"

#include <gtest/gtest.h>

#include "support/box_world.hpp"

namespace segdf {
namespace {

std::vector<PointRole> allUsed(const Scan& scan) {
  return std::vector<PointRole>(scan.points.size(), PointRole::kObject);
}

TEST(RangeImage, RowsCountFromTheTopmostLaserWhicheverWayRingsCount) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const RangeImage down(scan.points, allUsed(scan), RangeImageConfig{});
  for (Point& p : scan.points) p.ring = static_cast<std::int16_t>(63 - p.ring);
  const RangeImage up(scan.points, allUsed(scan), RangeImageConfig{});
  for (std::size_t i = 0; i < scan.points.size(); ++i) ASSERT_EQ(down.rowOf(i), up.rowOf(i));
  EXPECT_EQ(down.rowOf(scan.points.size() - 1), down.rows() - 1);
}

TEST(RangeImage, WithoutRingsRowsComeFromElevation) {
  Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  for (Point& p : scan.points) p.ring = -1;
  RangeImageConfig config;
  config.elevation_max = 2.0;
  config.elevation_min = -24.8;
  const RangeImage image(scan.points, allUsed(scan), config);
  for (std::size_t i = 1; i < scan.points.size(); ++i) {
    ASSERT_GE(image.rowOf(i), image.rowOf(i - 1));  // the scan is ring-major from the top
  }
  EXPECT_EQ(image.rowOf(scan.points.size() - 1), 63);
}

TEST(RangeImage, ColumnsWrap) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const RangeImage image(scan.points, allUsed(scan), RangeImageConfig{});
  for (int row : {10, 40}) {
    EXPECT_EQ(image.at(row, -1), image.at(row, image.columns() - 1));
    EXPECT_EQ(image.at(row, image.columns()), image.at(row, 0));
  }
  EXPECT_EQ(image.at(-1, 0), RangeImage::kNone);
  EXPECT_EQ(image.at(image.rows(), 0), RangeImage::kNone);
}

TEST(Surfaces, AWallHasItsNormalTowardsTheSensor) {
  const Scan scan = test::makeStreet().scan(0.0, 0.0, 0.0, 0);
  const RangeImage image(scan.points, allUsed(scan), RangeImageConfig{});
  const auto surfaces = estimateSurfaces(scan.points, allUsed(scan), image, RangeImageConfig{}, 1);
  std::size_t checked = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Point& p = scan.points[i];
    // The middle of the left wall, away from ground and edges.
    if (p.y < 11.4F || std::abs(p.x) > 8.0F || p.z < -1.0F || !surfaces[i].hasNormal()) continue;
    ++checked;
    ASSERT_LT(surfaces[i].normal.y(), -0.99F);
    ASSERT_LT(surfaces[i].curvature, 1e-3F);
  }
  EXPECT_GT(checked, 500U);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/line_roughness.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "segdf/segmentation/clustering.hpp"

namespace segdf {
namespace {

constexpr float kStep = 0.0031416F;  // rad: 2000 columns

/// One line of a laser: a wall 10 m away along the y axis, met at up to 72 degrees, so that ranges
/// of neighbours differ by up to 0.3 m.
std::vector<Point> wall() {
  std::vector<Point> points;
  for (int k = -400; k <= 400; ++k) {
    Point p;
    p.x = 10.0F;
    p.y = 10.0F * std::tan(kStep * static_cast<float>(k));
    p.ring = 0;
    points.push_back(p);
  }
  return points;
}

/// Moves every second point along its ray by this, metres.
std::vector<Point> rough(std::vector<Point> points, float depth) {
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const float range = points[i].position().norm();
    points[i].x *= (range + depth) / range;
    points[i].y *= (range + depth) / range;
  }
  return points;
}

std::vector<Surface> measure(const std::vector<Point>& points,
                             const std::vector<std::int32_t>& cluster,
                             int threads = 1) {
  RangeImageConfig config;
  config.columns = 2000;
  const RangeImage image(points, std::vector<PointRole>(points.size(), PointRole::kObject), config);
  std::vector<Surface> surfaces(points.size());
  measureRoughness(points, image, cluster, threads, surfaces);
  return surfaces;
}

TEST(LineRoughness, AFlatWallHasNoneFromAnyAngle) {
  const std::vector<Point> points = wall();
  const auto surfaces = measure(points, std::vector<std::int32_t>(points.size(), 0));
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    ASSERT_GE(surfaces[i].roughness, 0.0F) << i;
    ASSERT_LT(surfaces[i].roughness, 0.001F) << i;
  }
  EXPECT_LT(surfaces.front().roughness, 0.0F) << "nothing to its right";
}

TEST(LineRoughness, ItIsTheDistanceFromTheLineBetweenTheNeighbours) {
  const std::vector<Point> points = rough(wall(), 0.2F);
  const auto surfaces = measure(points, std::vector<std::int32_t>(points.size(), 0));
  for (std::size_t i = 300; i <= 500; ++i) EXPECT_NEAR(surfaces[i].roughness, 0.2F, 0.01F) << i;
}

TEST(LineRoughness, BesideAnotherClusterItIsNotKnown) {
  const std::vector<Point> points = wall();
  std::vector<std::int32_t> cluster(points.size(), 0);
  std::fill(cluster.begin() + 400, cluster.end(), 1);
  std::fill(cluster.begin() + 600, cluster.end(), Clusters::kNoise);
  const auto surfaces = measure(points, cluster);
  EXPECT_GE(surfaces[398].roughness, 0.0F);
  EXPECT_LT(surfaces[399].roughness, 0.0F);
  EXPECT_LT(surfaces[400].roughness, 0.0F);
  EXPECT_GE(surfaces[401].roughness, 0.0F);
  EXPECT_LT(surfaces[700].roughness, 0.0F) << "in no cluster";
}

TEST(LineRoughness, ThreadsDoNotChangeIt) {
  const std::vector<Point> points = rough(wall(), 0.1F);
  const std::vector<std::int32_t> cluster(points.size(), 0);
  const auto one = measure(points, cluster, 1);
  const auto three = measure(points, cluster, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(one[i].roughness, three[i].roughness) << i;
  }
}

TEST(LineRoughness, PointsOnTheAxisAreHarmless) {
  std::vector<Point> points(40);  // all at the sensor
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z = static_cast<float>(i);
  const auto surfaces = measure(points, std::vector<std::int32_t>(points.size(), 0));
  for (const Surface& surface : surfaces) EXPECT_FALSE(std::isnan(surface.roughness));
}

}  // namespace
}  // namespace segdf

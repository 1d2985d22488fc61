// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/vehicle_feet.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "segdf/segmentation/range_image.hpp"

namespace segdf {
namespace {

constexpr float kSlope = 0.05F;

/// A car's side on a road that rises ahead, with the state before settleFeet.
class Road {
 public:
  Road() {
    for (int row = 0; row < 24; ++row) {
      for (int column = 0; column < 24; ++column) {
        add(8.0F + 0.25F * static_cast<float>(row), -3.0F + 0.25F * static_cast<float>(column),
            0.0F, PointRole::kGround);
      }
    }
    for (int along = 0; along < 20; ++along) {
      for (int up = 0; up < 10; ++up) {
        add(10.0F, -2.0F + 0.2F * static_cast<float>(along), 0.2F + 0.12F * static_cast<float>(up),
            PointRole::kObject);
        add(11.0F, -2.0F + 0.2F * static_cast<float>(along), 0.2F + 0.12F * static_cast<float>(up),
            PointRole::kObject);
      }
    }
  }

  /// @param height over the road. @returns its index
  std::size_t add(float x, float y, float height, PointRole role) {
    Point p;
    p.x = x;
    p.y = y;
    p.z = height + level(x);
    points.push_back(p);
    roles.push_back(role);
    heights.push_back(height);
    return points.size() - 1;
  }

  /// All object points are one cluster.
  void settle() {
    const Config config;
    const CurvedGrid grid(config.cvi, 1.0);
    std::vector<KeyedPoint> items;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (roles[i] != PointRole::kObject) continue;
      items.emplace_back(*grid.keyOf(points[i].position().cast<double>()), i);
    }
    voxels = buildCurvedVoxels(items, std::vector<float>(points.size(), 0.0F));
    clusters.of_voxel.assign(voxels.size(), 0);
    clusters.count = 1;
    const RangeImage image(points, roles, config.range_image);
    const auto shapes = shapesOf(points, image, heights, config.vehicle, voxels, clusters);
    settleFeet(points, config.vehicle, grid, shapes, roles, voxels, clusters);
  }

  /// Clusters of a point: one for each place in a voxel.
  std::vector<std::int32_t> clustersOf(std::size_t point) const {
    std::vector<std::int32_t> found;
    forEachMember(voxels, clusters, [&](std::size_t cluster, std::uint32_t i) {
      if (i == point) found.push_back(static_cast<std::int32_t>(cluster));
    });
    return found;
  }

  std::vector<Point> points;
  std::vector<PointRole> roles;
  std::vector<float> heights;
  CurvedVoxels voxels;
  Clusters clusters;

 private:
  static float level(float x) { return -2.2F + kSlope * x; }
};

const std::vector<std::int32_t> kInNone;
const std::vector<std::int32_t> kInCar{0};

TEST(VehicleFeet, RoadInACarsClusterIsGround) {
  Road road;
  const std::size_t near = road.add(9.8F, 0.1F, 0.0F, PointRole::kObject);
  const std::size_t far = road.add(11.2F, 0.1F, -0.01F, PointRole::kObject);
  const std::size_t wheel = road.add(10.0F, 1.0F, 0.06F, PointRole::kObject);
  road.settle();
  EXPECT_EQ(road.roles[near], PointRole::kGround);
  EXPECT_EQ(road.roles[far], PointRole::kGround);
  EXPECT_EQ(road.roles[wheel], PointRole::kObject);
  EXPECT_EQ(road.clustersOf(near), kInNone);
  EXPECT_EQ(road.clustersOf(far), kInNone);
  EXPECT_EQ(road.clustersOf(wheel), kInCar);
}

TEST(VehicleFeet, GroundThatStandsOutOfTheRoadInItsFootprintIsTheCars) {
  Road road;
  const std::size_t sill = road.add(10.5F, 0.1F, 0.15F, PointRole::kGround);
  const std::size_t under = road.add(10.5F, 0.3F, 0.05F, PointRole::kGround);
  const std::size_t beside = road.add(10.5F, 2.4F, 0.15F, PointRole::kGround);
  road.settle();
  EXPECT_EQ(road.roles[sill], PointRole::kObject);
  EXPECT_EQ(road.clustersOf(sill), kInCar);
  EXPECT_EQ(road.roles[under], PointRole::kGround);
  EXPECT_EQ(road.roles[beside], PointRole::kGround);
}

TEST(VehicleFeet, EveryObjectPointIsInOneVoxelAndKeysAscend) {
  Road road;
  road.add(9.8F, 0.1F, 0.0F, PointRole::kObject);
  road.add(10.5F, 0.1F, 0.15F, PointRole::kGround);
  road.settle();
  std::vector<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < road.points.size(); ++i) {
    if (road.roles[i] == PointRole::kObject) expected.push_back(i);
  }
  std::vector<std::uint32_t> found = road.voxels.points;
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
  EXPECT_TRUE(std::is_sorted(road.voxels.keys.begin(), road.voxels.keys.end()));
  ASSERT_EQ(road.voxels.begin.size(), road.voxels.size() + 1);
  EXPECT_EQ(road.clusters.of_voxel.size(), road.voxels.size());
  for (std::size_t v = 0; v < road.voxels.size(); ++v) EXPECT_GT(road.voxels.count(v), 0U);
}

TEST(VehicleFeet, WhatLiesUnderTheRoadDoesNotStandOnIt) {
  Road road;
  const std::size_t low = road.add(9.8F, 0.1F, 0.0F, PointRole::kObject);
  for (int k = 0; k < 8; ++k) {
    road.add(10.0F, -0.8F + 0.2F * static_cast<float>(k), -0.3F, PointRole::kObject);
  }
  road.settle();
  EXPECT_EQ(road.roles[low], PointRole::kObject);
}

TEST(VehicleFeet, WhatIsMostlyAsLowAsTheRoadIsLeft) {
  Road road;
  std::vector<std::size_t> low;
  low.reserve(150);
  for (int k = 0; k < 150; ++k) {
    low.push_back(road.add(10.2F + 0.004F * static_cast<float>(k), 0.1F, 0.0F, PointRole::kObject));
  }
  road.settle();
  for (std::size_t i : low) EXPECT_EQ(road.roles[i], PointRole::kObject);
}

}  // namespace
}  // namespace segdf

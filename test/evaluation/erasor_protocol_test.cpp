// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/erasor_protocol.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

ClassedPoints cloud(const std::vector<std::pair<Eigen::Vector3f, std::uint16_t>>& points) {
  ClassedPoints result;
  for (const auto& [point, semantic_class] : points) result.add(point, semantic_class);
  return result;
}

TEST(VoxelFilter, CentroidAndClassOfTheNearestPoint) {
  // Three points in one voxel: centroid x = 0.08, nearest is the point at 0.09.
  const ClassedPoints voxels = voxelFilter(
      cloud({{{0.01F, 0.1F, 0.1F}, 40}, {{0.14F, 0.1F, 0.1F}, 50}, {{0.09F, 0.1F, 0.1F}, 252}}),
      0.2);
  ASSERT_EQ(voxels.points.size(), 1U);
  EXPECT_NEAR(voxels.points[0].x(), 0.08F, 1e-6F);
  EXPECT_EQ(voxels.classes[0], 252);
}

TEST(VoxelFilter, TheNearestPointMayLieInTheNextVoxel) {
  // The centroid is (0.1, 0.105, 0.105); its own points are 0.12 m away from it, that of the next
  // voxel 0.105 m.
  const ClassedPoints voxels = voxelFilter(cloud({{{0.1F, 0.02F, 0.02F}, 40},
                                                  {{0.1F, 0.19F, 0.19F}, 40},
                                                  {{0.205F, 0.105F, 0.105F}, 252}}),
                                           0.2);
  ASSERT_EQ(voxels.points.size(), 2U);
  EXPECT_EQ(voxels.classes[0], 252);
}

TEST(VoxelFilter, VoxelsBelowZeroAreTheirOwn) {
  EXPECT_EQ(voxelCentroids({{-0.01F, 0.0F, 0.0F}, {0.01F, 0.0F, 0.0F}}, 0.2).size(), 2U);
}

TEST(Erasor, HandComputedExample) {
  const ClassedPoints truth = cloud({{{0.1F, 0.1F, 0.1F}, 40},
                                     {{1.1F, 0.1F, 0.1F}, 50},
                                     {{2.1F, 0.1F, 0.1F}, 0},  // unlabelled is static
                                     {{3.1F, 0.1F, 0.1F}, 70},
                                     {{4.1F, 0.1F, 0.1F}, 252},
                                     {{5.1F, 0.1F, 0.1F}, 258},  // a moving class as any other
                                     {{6.1F, 0.1F, 0.1F}, 254},
                                     {{7.1F, 0.1F, 0.1F}, 259}});
  const ClassedPoints estimate = cloud({{{0.15F, 0.1F, 0.1F}, 40},   // 5 cm away: preserved
                                        {{1.27F, 0.1F, 0.1F}, 50},   // 17 cm: preserved
                                        {{2.28F, 0.1F, 0.1F}, 0},    // 18 cm: too far
                                        {{3.1F, 0.1F, 0.1F}, 253},   // there, but dynamic
                                        {{4.1F, 0.1F, 0.1F}, 252},   // remains
                                        {{5.1F, 0.1F, 0.1F}, 40}});  // there, but static
  const VoxelScores scores = compareVoxelMaps(truth, estimate);
  EXPECT_EQ(scores.preserved.part, 2U);
  EXPECT_EQ(scores.preserved.whole, 4U);
  EXPECT_EQ(scores.remaining_dynamic.part, 1U);
  EXPECT_EQ(scores.remaining_dynamic.whole, 4U);
  EXPECT_DOUBLE_EQ(*scores.preservationRate(), 50.0);
  EXPECT_DOUBLE_EQ(*scores.rejectionRate(), 75.0);
  EXPECT_DOUBLE_EQ(*scores.f1(), 0.6);
}

TEST(Erasor, TheNearestEstimateDecidesNotAnyWithinReach) {
  const ClassedPoints truth = cloud({{{0.1F, 0.1F, 0.1F}, 40}});
  const ClassedPoints estimate =
      cloud({{{0.15F, 0.1F, 0.1F}, 252}, {{0.0F, 0.1F, 0.1F}, 40}});  // 5 and 10 cm
  EXPECT_EQ(compareVoxelMaps(truth, estimate).preserved.part, 0U);
}

TEST(Erasor, DoingNothingPreservesAllAndRejectsNothing) {
  VoxelMapBuilder builder;
  for (int scan = 0; scan < 3; ++scan) {
    ClassedPoints points;
    for (int k = 0; k < 200; ++k) {
      const auto t = static_cast<float>(k);
      points.add({std::fmod(0.37F * t, 9.0F), std::fmod(0.73F * t, 5.0F), 0.01F * t},
                 k % 7 == 0 ? 252 : 50);
    }
    builder.add(points);
  }
  const ClassedPoints map = builder.finish();
  const VoxelScores scores = compareVoxelMaps(map, map);
  EXPECT_DOUBLE_EQ(*scores.preservationRate(), 100.0);
  EXPECT_DOUBLE_EQ(*scores.rejectionRate(), 0.0);
  EXPECT_DOUBLE_EQ(*scores.f1(), 0.0);
}

TEST(Erasor, ScansAreFilteredBeforeTheyAreAccumulated) {
  // One scan with nine points at 0.01 and one with a single point at 0.19: filtered scan by scan
  // the centroid is 0.10, all at once it would be 0.028.
  VoxelMapBuilder builder;
  ClassedPoints many;
  for (int k = 0; k < 9; ++k) many.add({0.01F, 0.1F, 0.1F}, 40);
  builder.add(many);
  builder.add(cloud({{{0.19F, 0.1F, 0.1F}, 40}}));
  EXPECT_NEAR(builder.finish().points.at(0).x(), 0.10F, 1e-6F);
}

TEST(Erasor, PointsNextToTheSensorTakeNoPart) {
  EXPECT_FALSE(VoxelMapBuilder::takes({2.69F, 0.0F, 5.0F}));
  EXPECT_TRUE(VoxelMapBuilder::takes({2.71F, 0.0F, 0.0F}));
  EXPECT_FALSE(VoxelMapBuilder::takes({std::nanf(""), 5.0F, 0.0F}));
}

TEST(Erasor, ClassesAreTransferredFromTheNearestTruth) {
  const ClassedPoints truth = cloud({{{0.0F, 0.0F, 0.0F}, 40}, {{1.0F, 0.0F, 0.0F}, 252}});
  const ClassedPoints map =
      transferClasses(truth, {{0.3F, 0.0F, 0.0F}, {0.7F, 0.0F, 0.0F}, {9.0F, 0.0F, 0.0F}});
  EXPECT_EQ(map.classes, (std::vector<std::uint16_t>{40, 252, 0}));
}

TEST(Erasor, WithoutDynamicTruthThereIsNoRejectionRate) {
  const ClassedPoints map = cloud({{{0.1F, 0.1F, 0.1F}, 40}});
  EXPECT_FALSE(compareVoxelMaps(map, map).rejectionRate());
  EXPECT_FALSE(compareVoxelMaps(map, map).f1());
}

}  // namespace
}  // namespace segdf

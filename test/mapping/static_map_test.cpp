// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/mapping/static_map.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace segdf {
namespace {

FrameResult frameWith(const std::vector<PointState>& states) {
  FrameResult frame;
  for (std::size_t i = 0; i < states.size(); ++i) {
    frame.scan.points.push_back({static_cast<float>(i), 0.05F, 0.05F, 0.25F, 0.0F, -1});
    frame.labels.push_back(
        {static_cast<std::uint32_t>(70000 + i), states[i], ObjectClass::kUnknown});
  }
  return frame;
}

TEST(StaticMap, HoldsGroundStaticAndNoiseOnly) {
  StaticMap map(0.1);
  map.add(frameWith({PointState::kGround, PointState::kDynamic, PointState::kStatic,
                     PointState::kUnjudged, PointState::kNoise}));
  ASSERT_EQ(map.points().size(), 3U);
  EXPECT_EQ(map.points()[0].label, 40U);
  EXPECT_EQ(map.points()[1].label, 9U);
  EXPECT_EQ(map.points()[1].instance, 70002U) << "ids are kept whole";
  EXPECT_FLOAT_EQ(map.points()[1].intensity, 0.25F);
}

TEST(StaticMap, IsInTheMapFrame) {
  FrameResult frame = frameWith({PointState::kStatic});
  frame.scan.pose.translation() = Eigen::Vector3d(100.0, 200.0, 3.0);
  StaticMap map(0.1);
  map.add(frame);
  EXPECT_NEAR(map.points()[0].x, 100.0F, 1e-4F);
  EXPECT_NEAR(map.points()[0].z, 3.05F, 1e-4F);
}

TEST(StaticMap, SeeingTheSameAgainAddsNothing) {
  StaticMap map(0.1);
  map.add(frameWith({PointState::kStatic, PointState::kStatic}));
  const std::size_t once = map.points().size();
  for (int k = 0; k < 10; ++k) map.add(frameWith({PointState::kStatic, PointState::kStatic}));
  EXPECT_EQ(map.points().size(), once);
  map.clear();
  EXPECT_TRUE(map.points().empty());
}

TEST(StaticMap, WhatIsRevokedLeavesRoomForWhatComesLater) {
  StaticMap map(0.1);
  FrameResult frame = frameWith({PointState::kStatic, PointState::kStatic, PointState::kGround});
  for (std::size_t scan : {4U, 5U}) {
    frame.index = scan;
    map.add(frame);
  }
  Revocation revocation;
  revocation.id = 70001;
  revocation.first = 5;
  revocation.last = 9;
  EXPECT_TRUE(map.revoke(revocation).empty()) << "the point came with scan 4";
  revocation.first = 0;
  const std::vector<MapPoint> revoked = map.revoke(revocation);
  ASSERT_EQ(revoked.size(), 1U);
  EXPECT_EQ(revoked[0].instance, 70001U);
  ASSERT_EQ(map.points().size(), 2U);
  EXPECT_EQ(map.points()[1].label, 40U) << "the others keep their order";
  map.add(frame);
  EXPECT_EQ(map.points().size(), 3U);
}

TEST(StaticMap, NegativeCoordinatesHaveTheirOwnVoxels) {
  FrameResult frame = frameWith({PointState::kStatic, PointState::kStatic});
  frame.scan.points[0].x = -0.05F;
  frame.scan.points[1].x = 0.05F;
  StaticMap map(0.1);
  map.add(frame);
  EXPECT_EQ(map.points().size(), 2U);
}

TEST(StaticMap, RefusesAVoxelOfZero) { EXPECT_THROW(StaticMap(0.0), std::invalid_argument); }

TEST(Thinned, KeepsTheFirstPointOfEachVoxel) {
  const std::vector<MapPoint> points{{0.1F, 0.0F, 0.0F, 0.0F, 1, 0},
                                     {0.4F, 0.0F, 0.0F, 0.0F, 2, 0},
                                     {0.6F, 0.0F, 0.0F, 0.0F, 3, 0}};
  const std::vector<MapPoint> coarse = thinned(points, 0.5);
  ASSERT_EQ(coarse.size(), 2U);
  EXPECT_EQ(coarse[0].label, 1U);
  EXPECT_EQ(coarse[1].label, 3U);
  EXPECT_EQ(thinned(points, 0.0).size(), 3U) << "0 keeps all";
  EXPECT_THROW(thinned(points, -0.1), std::invalid_argument);
  EXPECT_THROW(thinned(points, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/instance_links.hpp"

#include <gtest/gtest.h>

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

using test::makeKeyFrame;
using test::segmentAt;

/// A van seen whole in one scan, and as two halves behind a pillar in the other.
class FusionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    // Stage 2 of the clustering would close the gap by itself: different paint keeps the halves
    // apart.
    test::BoxWorld whole;
    whole.add(10.0, 5.0, 1.8, 4.0, 1.6, 0.2F);
    whole.add(20.0, -9.0, 1.0, 1.0, 1.6, 0.2F);
    test::BoxWorld halves;
    halves.add(10.0, 3.85, 1.8, 1.7, 1.6, 0.1F);
    halves.add(10.0, 6.15, 1.8, 1.7, 1.6, 0.6F);
    halves.add(20.0, -9.0, 1.0, 1.0, 1.6, 0.2F);
    from_ = makeKeyFrame(whole.scan(0.0, 0.0, 0.0, 1), config_);
    to_ = makeKeyFrame(halves.scan(0.0, 0.0, 0.0, 2), config_);
    for (Instance& instance : from_->instances) instance.id = ids_.next();
    overlaps_ = overlapSegments(*from_, pointsOfSegments(*from_), *to_, grid_, 1);
  }

  Config config_;
  CurvedGrid grid_{config_.cvi, config_.input.min_range};
  IdSource ids_;
  std::unique_ptr<KeyFrame> from_;
  std::unique_ptr<KeyFrame> to_;
  std::vector<SegmentOverlap> overlaps_;
};

TEST_F(FusionTest, TheHalvesBecomeOneInstanceWithTheIdOfTheWhole) {
  const std::size_t before = to_->seg.segments.size();
  ASSERT_NE(segmentAt(*to_, 10.0, 3.85), segmentAt(*to_, 10.0, 6.15));
  fuseSegments(*from_, *to_, config_, overlaps_);
  EXPECT_EQ(to_->seg.segments.size(), before - 1);
  passOnIds(*from_, *to_, overlaps_, config_.df, ids_);
  const std::size_t fused = segmentAt(*to_, 10.0, 5.0);
  EXPECT_TRUE(to_->instances[fused].fused);
  EXPECT_EQ(to_->instances[fused].id, from_->instances[segmentAt(*from_, 10.0, 5.0)].id);
  EXPECT_NEAR(to_->seg.segments[fused].box.size.x(), 4.0F, 0.1F);
}

TEST_F(FusionTest, VoxelsAndOverlapsFollowTheNewNumbers) {
  fuseSegments(*from_, *to_, config_, overlaps_);
  const auto count = static_cast<std::int32_t>(to_->seg.segments.size());
  for (std::int32_t cluster : to_->seg.clusters.of_voxel) EXPECT_LT(cluster, count);
  for (const SegmentOverlap& overlap : overlaps_) {
    for (const Neighbour& neighbour : overlap.neighbours) {
      EXPECT_LT(neighbour.segment, count);
      EXPECT_LE(neighbour.voxels, overlap.voxels);
    }
  }
}

TEST_F(FusionTest, WhatTogetherIsLargerThanAnObjectStaysApart) {
  config_.cvi.merge_long_side = 3.0;
  const std::size_t before = to_->seg.segments.size();
  fuseSegments(*from_, *to_, config_, overlaps_);
  EXPECT_EQ(to_->seg.segments.size(), before);
}

TEST_F(FusionTest, WithoutFusionOneHalfInheritsTheIdAndTheOtherGetsANewOne) {
  passOnIds(*from_, *to_, overlaps_, config_.df, ids_);
  const std::uint32_t whole = from_->instances[segmentAt(*from_, 10.0, 5.0)].id;
  const std::uint32_t left = to_->instances[segmentAt(*to_, 10.0, 6.15)].id;
  const std::uint32_t right = to_->instances[segmentAt(*to_, 10.0, 3.85)].id;
  EXPECT_NE(left, right);
  EXPECT_TRUE(left == whole || right == whole);
}

/// A car of which only the rear end is seen, and 0.3 s later all of it.
class GrowingCarTest : public ::testing::Test {
 protected:
  /// @param speed it was seen to have, m/s. @return whether it keeps its id
  bool keepsItsId(double speed) {
    test::BoxWorld rear;
    rear.add(14.0, 8.0, 1.5, 1.8, 1.5);
    test::BoxWorld whole;
    whole.add(18.5, 8.0, 4.2, 1.8, 1.5);
    const std::unique_ptr<KeyFrame> from = makeKeyFrame(rear.scan(0.0, 0.0, 0.0, 1), config_);
    const std::unique_ptr<KeyFrame> to =
        makeKeyFrame(whole.scan(0.0, 0.0, 0.0, 300000001), config_);
    IdSource ids;
    for (Instance& instance : from->instances) instance.id = ids.next();
    Instance& car = from->instances[segmentAt(*from, 14.0, 8.0)];
    car.velocity.x() = speed;
    const CurvedGrid grid(config_.cvi, config_.input.min_range);
    passOnIds(*from, *to, overlapSegments(*from, pointsOfSegments(*from), *to, grid, 1), config_.df,
              ids);
    return to->instances[segmentAt(*to, 18.5, 8.0)].id == car.id;
  }

  Config config_;
};

TEST_F(GrowingCarTest, KeepsItsIdWhereItsMotionLeads) { EXPECT_TRUE(keepsItsId(15.0)); }

TEST_F(GrowingCarTest, IsAnotherWhereItsMotionDoesNotLead) { EXPECT_FALSE(keepsItsId(8.0)); }

}  // namespace
}  // namespace segdf

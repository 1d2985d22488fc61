// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/instance_links.hpp"

#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

using test::makeKeyFrame;
using test::segmentAt;

/// Key frames that get their ids from those before them.
class LinksTest : public ::testing::Test {
 protected:
  void nameAll(KeyFrame& first) {
    for (Instance& instance : first.instances) instance.id = ids_.next();
  }

  void link(const Window& before, KeyFrame& to) {
    const KeyFrame& last = *before.back();
    passOnIds(before, to, overlapSegments(last, pointsOfSegments(last), to, grid_, 1), config_.df,
              ids_);
  }

  Config config_;
  CurvedGrid grid_{config_.cvi, config_.input.min_range};
  IdSource ids_;
};

/// A van seen whole in one scan, and as two halves behind a pillar in the other.
class FusionTest : public LinksTest {
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
    nameAll(*from_);
    overlaps_ = overlapSegments(*from_, pointsOfSegments(*from_), *to_, grid_, 1);
  }

  std::unique_ptr<KeyFrame> from_;
  std::unique_ptr<KeyFrame> to_;
  std::vector<SegmentOverlap> overlaps_;
};

TEST_F(FusionTest, TheHalvesBecomeOneInstanceWithTheIdOfTheWhole) {
  const std::size_t before = to_->seg.segments.size();
  ASSERT_NE(segmentAt(*to_, 10.0, 3.85), segmentAt(*to_, 10.0, 6.15));
  fuseSegments(*from_, *to_, config_, overlaps_);
  EXPECT_EQ(to_->seg.segments.size(), before - 1);
  passOnIds({from_.get()}, *to_, overlaps_, config_.df, ids_);
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
  passOnIds({from_.get()}, *to_, overlaps_, config_.df, ids_);
  const std::uint32_t whole = from_->instances[segmentAt(*from_, 10.0, 5.0)].id;
  const std::uint32_t left = to_->instances[segmentAt(*to_, 10.0, 6.15)].id;
  const std::uint32_t right = to_->instances[segmentAt(*to_, 10.0, 3.85)].id;
  EXPECT_NE(left, right);
  EXPECT_TRUE(left == whole || right == whole);
  const Instance& other = to_->instances[segmentAt(*to_, 10.0, left == whole ? 3.85 : 6.15)];
  EXPECT_EQ(other.parent, whole);
}

/// A car of which only the rear end is seen, and 0.3 s later all of it.
class GrowingCarTest : public LinksTest {
 protected:
  /// @param speed it was seen to have, m/s. @param left the later scan sees through its place
  /// @param x where it is then. @return whether it keeps its id
  bool keepsItsId(double speed, bool left = false, double x = 18.5) {
    test::BoxWorld rear;
    rear.add(14.0, 8.0, 1.0, 1.0, 1.5);
    test::BoxWorld whole;
    whole.add(x, 8.0, 2.4, 1.8, 1.5);
    const std::unique_ptr<KeyFrame> from = makeKeyFrame(rear.scan(0.0, 0.0, 0.0, 1), config_);
    const std::unique_ptr<KeyFrame> to =
        makeKeyFrame(whole.scan(0.0, 0.0, 0.0, 300000001), config_);
    nameAll(*from);
    to->index = 1;
    const std::size_t end = segmentAt(*from, 14.0, 8.0);
    Instance& car = from->instances[end];
    car.velocity.x() = speed;
    from->evidence = std::make_shared<FrameEvidence>(prepareEvidence(*from, config_.df));
    from->evidence->votes.resize(from->instances.size());
    if (left) from->evidence->votes[end].push_back({1, 0.3F, 20, 0, true});
    link({from.get()}, *to);
    return to->instances[segmentAt(*to, x, 8.0)].id == car.id;
  }
};

TEST_F(GrowingCarTest, KeepsItsIdWhereItsMotionLeads) { EXPECT_TRUE(keepsItsId(15.0)); }

TEST_F(GrowingCarTest, IsAnotherWhereItsMotionDoesNotLead) { EXPECT_FALSE(keepsItsId(8.0)); }

TEST_F(GrowingCarTest, KeepsItsIdWhereItsPlaceWasSeenToBeLeft) {
  EXPECT_FALSE(keepsItsId(0.0, false, 16.3));
  EXPECT_TRUE(keepsItsId(0.0, true, 16.3));
  EXPECT_FALSE(keepsItsId(0.0, true, 17.5)) << "3.5 m away";
}

/// A car on a road, scan by scan.
class RoadTest : public LinksTest {
 protected:
  /// Takes a scan of a car at x, 8 m to the left; of an empty road where none is given.
  void scan(double seconds, std::optional<double> x, double height = 1.5) {
    test::BoxWorld world;
    world.add(6.0, -9.0, 1.0, 1.0, 1.6);
    if (x) world.add(*x, 8.0, 4.2, 1.8, height);
    const auto stamp = static_cast<std::uint64_t>(seconds * 1e9) + 1;
    frames_.push_back(makeKeyFrame(world.scan(0.0, 0.0, 0.0, stamp), config_));
    if (frames_.size() == 1) return nameAll(*frames_.back());
    Window before;
    for (std::size_t k = 0; k + 1 < frames_.size(); ++k) before.push_back(frames_[k].get());
    link(before, *frames_.back());
  }

  /// It drives from 2 to 3 m in two scans, is not seen in the next two, and is at x in the fifth.
  void hideUntil(double x) {
    scan(0.0, 2.0);
    scan(0.1, 3.0);
    scan(0.2, {});
    scan(0.3, {});
    scan(0.4, x);
  }

  const Instance& car(std::size_t frame, double x) const {
    return frames_[frame]->instances[segmentAt(*frames_[frame], x, 8.0)];
  }

  std::vector<std::unique_ptr<KeyFrame>> frames_;
};

TEST_F(RoadTest, WhatWasHiddenIsTheSameWhereItsMotionLeads) {
  hideUntil(6.0);
  EXPECT_EQ(car(4, 6.0).id, car(0, 2.0).id);
  EXPECT_NEAR(car(4, 6.0).velocity.x(), 10.0, 1.0);
}

TEST_F(RoadTest, NotWhereItDoesNot) {
  hideUntil(8.0);
  EXPECT_NE(car(4, 8.0).id, car(0, 2.0).id);
}

TEST_F(RoadTest, NotAfterMoreThanHalfASecond) {
  scan(0.0, 2.0);
  scan(0.1, 3.0);
  for (double seconds : {0.2, 0.3, 0.4, 0.5, 0.6}) scan(seconds, {});
  scan(0.7, 9.0);
  EXPECT_NE(car(7, 9.0).id, car(0, 2.0).id);
}

TEST_F(RoadTest, OfOneThatLooksOtherwiseNowTheHeightOfItsCentreSaysNothing) {
  scan(0.0, 0.0);
  scan(0.1, 2.0);
  scan(0.2, 4.0, 3.4);
  EXPECT_EQ(car(2, 4.0).id, car(0, 0.0).id);
}

TEST_F(RoadTest, AVelocityIsTakenOverHalfASecond) {
  for (int k = 0; k < 6; ++k) scan(0.1 * k, 1.0 * k + (k == 5 ? 0.3 : 0.0));
  EXPECT_NEAR(car(5, 5.3).velocity.x(), 10.6, 0.5) << "13 m/s by the last step";
}

/// A car seen whole at x = 6 m with some velocity, half a second later in two pieces from 4 to 8 m.
class BrakingCarTest : public LinksTest {
 protected:
  /// @return whether the piece that does not keep the id is known as a part of the car
  bool isPart(double speed) {
    test::BoxWorld whole;
    whole.add(6.0, 8.0, 4.2, 1.8, 1.5);
    test::BoxWorld pieces;
    pieces.add(4.5, 8.0, 1.2, 1.8, 1.5, 0.1F);
    pieces.add(6.85, 8.0, 2.5, 1.8, 1.5, 0.6F);
    const std::unique_ptr<KeyFrame> from = makeKeyFrame(whole.scan(0.0, 0.0, 0.0, 1), config_);
    const std::unique_ptr<KeyFrame> to =
        makeKeyFrame(pieces.scan(0.0, 0.0, 0.0, 500000001), config_);
    nameAll(*from);
    Instance& car = from->instances[segmentAt(*from, 6.0, 8.0)];
    car.velocity.x() = speed;
    link({from.get()}, *to);
    const Instance& rear = to->instances[segmentAt(*to, 4.5, 8.0)];
    const Instance& front = to->instances[segmentAt(*to, 6.85, 8.0)];
    EXPECT_TRUE((rear.id == car.id) != (front.id == car.id));
    return (rear.id == car.id ? front : rear).parent == car.id;
  }
};

TEST_F(BrakingCarTest, APieceIsAPartWhereTheCarWasAndWhereItWouldHaveGone) {
  EXPECT_TRUE(isPart(0.0));
  EXPECT_TRUE(isPart(4.0)) << "it would be 2 m ahead";
}

TEST_F(RoadTest, WhatComesBesideAMoverIsNoPartOfIt) {
  scan(0.0, 2.0);
  scan(0.1, 3.0);
  for (const Instance& instance : frames_[1]->instances) EXPECT_EQ(instance.parent, 0U);
}

}  // namespace
}  // namespace segdf

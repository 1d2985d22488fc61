// SPDX-License-Identifier: BSD-3-Clause
// What becomes of the id of a far car whose front is now a segment of its own, now one with the
// rest.
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/instance_links.hpp"

namespace segdf {
namespace {

constexpr std::uint32_t kRear = 1;
constexpr std::uint32_t kFront = 2;

/// Key frames of segments along a line, whose overlaps are given.
class PiecesTest : public ::testing::Test {
 protected:
  KeyFrame& addFrame(double seconds) {
    frames_.push_back(std::make_unique<KeyFrame>());
    frames_.back()->scan.stamp_ns = static_cast<std::int64_t>(seconds * 1e9);
    return *frames_.back();
  }

  /// From `begin` to `end`, metres.
  static void add(KeyFrame& frame, float begin, float end, std::uint32_t id = 0) {
    Segment& segment = frame.seg.segments.emplace_back();
    for (const float x : {begin, end}) {
      segment.points.push_back(static_cast<std::uint32_t>(frame.scan.points.size()));
      frame.scan.points.emplace_back().x = x;
    }
    segment.box.center.x() = 0.5F * (begin + end);
    segment.box.size = {end - begin, 1.8F, 1.5F};
    frame.instances.emplace_back().id = id;
  }

  /// All of an instance's voxels touch these segments of the next frame, so many each.
  static SegmentOverlap touches(const std::vector<std::uint32_t>& voxels) {
    SegmentOverlap overlap;
    for (std::size_t s = 0; s < voxels.size(); ++s) {
      overlap.voxels += voxels[s];
      if (voxels[s] > 0) overlap.neighbours.push_back({static_cast<std::int32_t>(s), voxels[s]});
    }
    overlap.occupied = overlap.voxels;
    return overlap;
  }

  /// Gives the newest frame its ids.
  void link(const std::vector<SegmentOverlap>& overlaps) {
    Window before;
    for (std::size_t k = 0; k + 1 < frames_.size(); ++k) before.push_back(frames_[k].get());
    for (std::uint32_t id = 0; id < kFront; ++id) ids_.next();
    passOnIds(before, *frames_.back(), overlaps, Config().df, ids_);
  }

  const Instance& instance(std::size_t s) const { return frames_.back()->instances[s]; }

  std::vector<std::unique_ptr<KeyFrame>> frames_;
  IdSource ids_;
};

/// Rear and front, which was there before or not, become one.
/// @param step between key frames, seconds
class MergeTest : public PiecesTest {
 protected:
  std::uint32_t idOfBoth(std::uint32_t rear_voxels, bool young = true, double step = 0.1) {
    frames_.clear();
    KeyFrame& first = addFrame(0.0);
    add(first, 0.0F, 0.4F, kRear);
    if (!young) add(first, 1.0F, 3.0F, kFront);
    KeyFrame& last = addFrame(step);
    add(last, 0.0F, 0.4F, kRear);
    add(last, 1.0F, 3.0F, kFront);
    add(addFrame(2.0 * step), 0.0F, 3.0F);
    link({touches({rear_voxels}), touches({20})});
    return instance(0).id;
  }
};

TEST_F(MergeTest, AFrontThatHasJustComeOffGivesItsIdUp) { EXPECT_EQ(idOfBoth(12), kRear); }

TEST_F(MergeTest, NotForAScrapOfTheRear) { EXPECT_EQ(idOfBoth(11), kFront); }

TEST_F(MergeTest, OfTwoThatHaveBeenThereForLongerTheLargerKeepsIt) {
  EXPECT_EQ(idOfBoth(19, false), kFront);
}

TEST_F(MergeTest, FarApartInTimeNobodyIsYoung) {
  EXPECT_EQ(idOfBoth(12, true, 0.25), kRear);
  EXPECT_EQ(idOfBoth(12, true, 0.26), kFront);
}

/// A car from 0 to 3 m is seen as a rear that keeps its id and as a front.
class FrontTest : public PiecesTest {
 protected:
  bool isPart(float begin, float end, std::uint32_t voxels) {
    frames_.clear();
    add(addFrame(0.0), 0.0F, 3.0F, kRear);
    KeyFrame& to = addFrame(0.1);
    add(to, 0.0F, 0.4F);
    add(to, begin, end);
    link({touches({30 - voxels, voxels})});
    EXPECT_EQ(instance(0).id, kRear);
    EXPECT_GT(instance(1).id, kFront);
    return instance(1).parent == kRear;
  }
};

TEST_F(FrontTest, WhatReachesFartherIsAPartIfItsCentreIsThereAndAThirdTouchesIt) {
  EXPECT_TRUE(isPart(0.8F, 4.2F, 10));
  EXPECT_FALSE(isPart(0.8F, 4.2F, 9)) << "three tenths";
  EXPECT_FALSE(isPart(2.5F, 4.5F, 10)) << "its centre is 0.5 m ahead of the car";
}

TEST_F(FrontTest, WhatLiesWithinIsAPart) { EXPECT_TRUE(isPart(0.8F, 3.2F, 5)); }

}  // namespace
}  // namespace segdf

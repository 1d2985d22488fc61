// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/split_keep.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr PlaceEvidence kMoved{3, 0};
constexpr PlaceEvidence kStood{0, 3};
constexpr std::size_t kPart = 40;  // points

/// A dynamic instance of a car's rear and one side, and a part of it that was found again.
class SplitKeep : public ::testing::Test {
 protected:
  SplitKeep() {
    frame_.seg.segments.emplace_back();
    frame_.instances.emplace_back();
    frame_.instances[0].id = ids_.next();
    frame_.instances[0].dynamic = true;
    for (float x = 8.0F; x < 12.05F; x += 0.05F) add({x, 3.0F, 1.0F}, kMoved);
    for (float y = 3.0F; y < 5.05F; y += 0.05F) add({8.0F, y, 1.0F}, kMoved);
  }

  void add(const Eigen::Vector3f& x, const PlaceEvidence& evidence) {
    Point p;
    p.x = x.x();
    p.y = x.y();
    p.z = x.z();
    frame_.seg.segments[0].points.push_back(static_cast<std::uint32_t>(frame_.scan.points.size()));
    frame_.scan.points.push_back(p);
    by_point_.push_back(evidence);
  }

  /// An upright part, 1 m high, that others found again.
  void addStanding(float x, float y) {
    for (std::size_t k = 0; k < kPart; ++k)
      add({x, y, 0.5F + 0.025F * static_cast<float>(k)}, kStood);
  }

  void keep() { keepStanding(frame_, by_point_, config_, grid_, ids_); }

  Config config_;
  CurvedGrid grid_{config_.cvi, config_.input.min_range};
  IdSource ids_;
  KeyFrame frame_;
  std::vector<PlaceEvidence> by_point_;
};

TEST_F(SplitKeep, WhatStandsBesideWhatMovedIsKept) {
  addStanding(10.0F, 2.5F);
  keep();
  ASSERT_EQ(frame_.instances.size(), 2U);
  EXPECT_FALSE(frame_.instances[1].dynamic);
  EXPECT_EQ(frame_.instances[1].reason, Reason::kKept);
  EXPECT_EQ(frame_.instances[1].parent, frame_.instances[0].id);
  EXPECT_EQ(frame_.seg.segments[1].points.size(), kPart);
  EXPECT_TRUE(frame_.instances[0].dynamic);
}

TEST_F(SplitKeep, OfWhatMovedAsAWholeNoPartStands) {
  frame_.instances[0].whole = true;
  addStanding(10.0F, 2.5F);
  keep();
  EXPECT_EQ(frame_.instances.size(), 1U);
}

TEST_F(SplitKeep, APartWithinWhatMovedIsItsOwnHoweverHighItIs) {
  addStanding(9.0F, 3.5F);
  keep();
  ASSERT_EQ(frame_.instances.size(), 1U);
  EXPECT_TRUE(frame_.instances[0].dynamic);
}

TEST_F(SplitKeep, AFewPointsAreNoPart) {
  config_.df.keep_min = static_cast<int>(kPart) + 1;
  addStanding(10.0F, 2.5F);
  keep();
  EXPECT_EQ(frame_.instances.size(), 1U);
}

TEST_F(SplitKeep, TheMovedPartOfWhatStandsIsSplitOff) {
  frame_.instances[0].dynamic = false;
  addStanding(10.0F, 2.5F);
  splitMoved(frame_, by_point_, config_, grid_, ids_);
  ASSERT_EQ(frame_.instances.size(), 2U);
  EXPECT_TRUE(frame_.instances[1].dynamic);
  EXPECT_EQ(frame_.instances[1].reason, Reason::kSplit);
  EXPECT_EQ(frame_.seg.segments[0].points.size(), kPart);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/reattachment.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"

namespace segdf {
namespace {

/// A frame with the side of a dynamic car, 4 m long and 1.5 m high, seen from the other side, and
/// what lies around it: above the ground of all that can be taken along.
class Reattachment : public ::testing::Test {
 protected:
  Reattachment() {
    frame_.evidence = std::make_shared<FrameEvidence>(prepareEvidence(KeyFrame{}, config_));
    std::vector<Eigen::Vector3f> side;
    for (float x = 8.0F; x < 12.1F; x += 0.2F) {
      for (float z = 0.4F; z < 1.6F; z += 0.2F) side.emplace_back(x, 3.0F, z);
      side.emplace_back(x, 4.0F, 1.4F);  // the roof's far edge
    }
    addSegment(side).dynamic = true;
  }

  std::uint32_t addPoint(const Eigen::Vector3f& x) {
    Point p;
    p.x = x.x();
    p.y = x.y();
    p.z = x.z();
    frame_.scan.points.push_back(p);
    frame_.seg.roles.push_back(PointRole::kObject);
    frame_.seg.height.push_back(x.z());
    return static_cast<std::uint32_t>(frame_.scan.points.size() - 1);
  }

  /// An instance that the votes left static.
  Instance& addSegment(const std::vector<Eigen::Vector3f>& places) {
    Segment segment;
    for (const Eigen::Vector3f& x : places) {
      segment.points.push_back(addPoint(x));
      segment.bounds.extend(x);
    }
    frame_.seg.segments.push_back(segment);
    frame_.instances.emplace_back();
    frame_.instances.back().reason = Reason::kVotes;
    return frame_.instances.back();
  }

  /// A few points, 0.3 m long.
  Instance& addPiece(float x, float y, float z = 1.0F) {
    return addSegment({{x, y, z}, {x + 0.1F, y, z}, {x + 0.2F, y, z}, {x + 0.3F, y, z}});
  }

  /// A point in no instance, and what was seen of it.
  std::uint32_t addLoose(const Eigen::Vector3f& x, std::uint8_t free, std::uint8_t hit) {
    const std::uint32_t i = addPoint(x);
    frame_.evidence->first.push_back(static_cast<std::uint32_t>(frame_.evidence->listed.size()));
    frame_.evidence->listed.push_back(i);
    frame_.evidence->free.push_back(free);
    frame_.evidence->hit.push_back(hit);
    return i;
  }

  bool isTakenLoose(std::uint32_t i) {
    const auto places = static_cast<std::uint32_t>(frame_.evidence->free.size());
    frame_.evidence->begin.assign(frame_.seg.segments.size() + 1, 0);
    frame_.evidence->begin.push_back(places);
    frame_.removed.clear();
    removeLoosePoints(frame_, config_);
    return std::count(frame_.removed.begin(), frame_.removed.end(), i) == 1;
  }

  DynamicConfig config_;
  KeyFrame frame_;
};

TEST_F(Reattachment, APieceInsideGoesWhenFewFoundItAgain) {
  addPiece(10.0F, 3.5F).static_votes = 2;
  removeEnclosed(frame_, config_);
  EXPECT_TRUE(frame_.instances[1].dynamic);
  EXPECT_EQ(frame_.instances[1].reason, Reason::kEnclosed);
}

TEST_F(Reattachment, APieceInsideStaysWhenItWasFoundAgain) {
  addPiece(10.0F, 3.5F).static_votes = 3;
  removeEnclosed(frame_, config_);
  EXPECT_FALSE(frame_.instances[1].dynamic);
  EXPECT_EQ(frame_.instances[1].reason, Reason::kVotes);
}

TEST_F(Reattachment, WhatWasFoundToStandByOtherProofsStays) {
  addPiece(10.0F, 3.5F).reason = Reason::kKept;
  addPiece(9.0F, 3.5F).reason = Reason::kRestored;
  removeEnclosed(frame_, config_);
  EXPECT_FALSE(frame_.instances[1].dynamic);
  EXPECT_FALSE(frame_.instances[2].dynamic);
}

TEST_F(Reattachment, WhatIsBesideOrAboveIsNotInside) {
  addPiece(10.0F, 2.5F);
  addPiece(10.0F, 3.5F, 2.2F);
  removeEnclosed(frame_, config_);
  EXPECT_FALSE(frame_.instances[1].dynamic) << "a sign on the sidewalk";
  EXPECT_FALSE(frame_.instances[2].dynamic) << "a bough over the roof";
}

TEST_F(Reattachment, WhatReachesInWithItsSmallerPartStays) {
  addSegment({{10.0F, 2.9F, 1.0F}, {10.0F, 2.5F, 1.0F}, {10.0F, 2.0F, 1.0F}});
  removeEnclosed(frame_, config_);
  EXPECT_FALSE(frame_.instances[1].dynamic);
}

TEST_F(Reattachment, ADoubtfulPointNearWhatMovedGoes) {
  EXPECT_TRUE(isTakenLoose(addLoose({10.0F, 5.5F, 1.0F}, 1, 0))) << "the far side, through glass";
  EXPECT_TRUE(isTakenLoose(addLoose({10.0F, 5.5F, 1.0F}, 2, 2)));
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 5.5F, 1.0F}, 2, 3)));
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 5.5F, 1.0F}, 0, 0))) << "nobody looked";
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 5.5F, 0.1F}, 1, 0))) << "a kerb";
}

TEST_F(Reattachment, BesideItSoDoesWhatNobodyLookedAtAndWhatIsLow) {
  EXPECT_TRUE(isTakenLoose(addLoose({10.0F, 4.8F, 1.0F}, 0, 0))) << "others saw its near side";
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 4.8F, 1.0F}, 0, 1)));
  EXPECT_TRUE(isTakenLoose(addLoose({10.0F, 4.8F, 0.1F}, 0, 0))) << "a wheel";
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 4.8F, 0.05F}, 0, 0))) << "the road";
}

TEST_F(Reattachment, WhereSomethingMovedAMomentAgoNothingStands) {
  const std::uint32_t inside = addLoose({20.5F, 3.4F, 1.0F}, 0, 0);
  EXPECT_FALSE(isTakenLoose(inside)) << "nobody looked";
  frame_.swept.push_back({Footprint({{20.0F, 3.0F}, {24.0F, 3.0F}, {20.0F, 4.0F}}), 0.4F, 1.5F});
  EXPECT_TRUE(isTakenLoose(inside));
  EXPECT_TRUE(isTakenLoose(addLoose({19.6F, 3.4F, 1.0F}, 2, 2))) << "0.4 m beside";
  EXPECT_FALSE(isTakenLoose(addLoose({20.5F, 3.4F, 1.0F}, 0, 1))) << "found again";
  EXPECT_FALSE(isTakenLoose(addLoose({20.5F, 3.4F, 0.05F}, 0, 0))) << "the road";
  EXPECT_FALSE(isTakenLoose(addLoose({19.4F, 3.4F, 1.0F}, 0, 0))) << "0.6 m beside";
  EXPECT_FALSE(isTakenLoose(addLoose({20.5F, 3.4F, 2.1F}, 0, 0))) << "0.6 m above";
}

TEST_F(Reattachment, FarFromWhatMovedAPointNeedsMore) {
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 6.5F, 1.0F}, 1, 0)));
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 3.5F, 4.0F}, 1, 0))) << "above it";
  EXPECT_FALSE(isTakenLoose(addLoose({10.0F, 6.5F, 1.0F}, 3, 2)));
  EXPECT_TRUE(isTakenLoose(addLoose({10.0F, 6.5F, 1.0F}, 4, 2)));
}

}  // namespace
}  // namespace segdf

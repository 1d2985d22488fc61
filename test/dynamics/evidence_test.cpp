// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/evidence.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

/// A wall before which somebody may stand, seen twice from almost the same place.
class EvidenceTest : public ::testing::Test {
 protected:
  EvidenceTest() { wall_.add(10.0, 6.0, 16.0, 0.4, 2.5); }

  /// @param person where somebody stands along the wall @param x where the sensor is
  std::unique_ptr<KeyFrame> see(double person, double x, std::int64_t stamp) {
    test::BoxWorld world = wall_;
    world.add(person, 5.6, 0.4, 0.4, 1.7);
    return test::makeKeyFrame(world.scan(x, 0.0, 0.0, stamp), config_);
  }

  /// All that stands in one segment, however it was clustered.
  static void unite(KeyFrame& frame) {
    Segmentation& seg = frame.seg;
    Segment whole;
    whole.points = seg.voxels.points;
    whole.object_class = ObjectClass::kHighMobility;  // of which every point is a place
    seg.segments.assign(1, whole);
    seg.clusters.of_voxel.assign(seg.voxels.size(), 0);
    seg.clusters.count = 1;
  }

  void prepare(KeyFrame& frame, KeyFrame& other) {
    unite(frame);
    frame.evidence = std::make_shared<FrameEvidence>(prepareEvidence(frame, config_.df));
    other.evidence = std::make_shared<FrameEvidence>(prepareEvidence(other, config_.df));
    listPlaces(frame);
  }

  void gather(KeyFrame& frame, const KeyFrame& other) {
    gatherEvidence(frame, other, pose(frame, other), config_.df, 1);
  }

  static Pose pose(const KeyFrame& frame, const KeyFrame& other) {
    return other.scan.pose.inverse() * frame.scan.pose;
  }

  /// What every single place is found to be.
  static std::vector<VolumetricState> statesOf(const KeyFrame& frame, const KeyFrame& other) {
    const FrameEvidence& evidence = *frame.evidence;
    std::vector<VolumetricState> states(evidence.free.size());
    other.evidence->image.look(evidence.places, pose(frame, other).cast<float>(), states.data());
    return states;
  }

  static std::size_t count(const std::vector<VolumetricState>& states, VolumetricState state) {
    return static_cast<std::size_t>(std::count(states.begin(), states.end(), state));
  }

  Config config_;
  test::BoxWorld wall_;
};

TEST_F(EvidenceTest, APersonWhoLeftIsSeenThroughInTheMiddleOfAWall) {
  const auto frame = see(9.0, 0.0, 1);
  const auto other = see(14.0, 0.3, 1000000001);
  prepare(*frame, *other);
  gather(*frame, *other);
  const std::vector<VolumetricState> states = statesOf(*frame, *other);
  const std::size_t free = count(states, VolumetricState::kFree);
  ASSERT_GE(free, static_cast<std::size_t>(config_.df.split_min));
  ASSERT_LT(10 * free, states.size()) << "a small part";
  std::size_t missed = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const PlaceEvidence answer = frame->evidence->answer(k);
    const bool seen_through = states[k] == VolumetricState::kFree;
    missed += seen_through && answer.free == 0 ? 1 : 0;
    ASSERT_TRUE(seen_through || answer.free == 0) << "place " << k;
  }
  EXPECT_LE(20 * missed, free);
}

TEST_F(EvidenceTest, SomePlacesOfWhatStandsSpeakForAll) {
  const auto frame = see(9.0, 0.0, 1);
  const auto other = see(9.0, 0.3, 1000000001);
  prepare(*frame, *other);
  gather(*frame, *other);
  const std::vector<VolumetricState> states = statesOf(*frame, *other);
  ASSERT_EQ(count(states, VolumetricState::kFree), 0U);
  ASSERT_EQ(frame->evidence->votes.front().size(), 1U);
  const PairVote& vote = frame->evidence->votes.front().front();
  EXPECT_EQ(vote.free, 0U);
  EXPECT_TRUE(vote.informative);
  double hit = 0.0;  // points: a place of a large segment stands for several
  const std::vector<std::uint32_t>& first = frame->evidence->first;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (states[k] == VolumetricState::kHit) hit += first[k + 1] - first[k];
  }
  EXPECT_NEAR(vote.hit, hit, 0.02 * hit);
}

TEST_F(EvidenceTest, EachPlaceInNoSegmentIsLookedAt) {
  const auto frame = see(9.0, 0.0, 1);
  const auto other = see(14.0, 0.3, 1000000001);
  prepare(*frame, *other);
  // What is in no segment comes last: here all of it.
  FrameEvidence& evidence = *frame->evidence;
  evidence.begin = {0, 0, static_cast<std::uint32_t>(evidence.free.size())};
  gather(*frame, *other);
  const std::vector<VolumetricState> states = statesOf(*frame, *other);
  for (std::size_t k = 0; k < states.size(); ++k) {
    ASSERT_EQ(evidence.free[k], states[k] == VolumetricState::kFree ? 1 : 0);
    ASSERT_EQ(evidence.hit[k], states[k] == VolumetricState::kHit ? 1 : 0);
  }
}

}  // namespace
}  // namespace segdf

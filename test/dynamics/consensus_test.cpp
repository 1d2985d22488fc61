// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/consensus.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"

namespace segdf {
namespace {

constexpr std::uint32_t kTrack = 7;
constexpr std::uint32_t kOther = 8;
constexpr std::size_t kPoints = 100;

/// Key frames whose instances are lorries, 8 m long.
class ConsensusTest : public ::testing::Test {
 protected:
  KeyFrame& addFrame() {
    frames_.push_back(std::make_unique<KeyFrame>());
    KeyFrame& frame = *frames_.back();
    frame.index = frames_.size() - 1;
    frame.evidence = std::make_shared<FrameEvidence>(prepareEvidence(KeyFrame{}, {}));
    return frame;
  }

  static Instance& add(KeyFrame& frame, std::uint32_t id, float x, std::size_t points) {
    Segment& segment = frame.seg.segments.emplace_back();
    segment.points.resize(points);
    segment.box.center.x() = x;
    segment.box.size = {8.0F, 2.4F, 3.0F};
    Instance& instance = frame.instances.emplace_back();
    instance.id = id;
    return instance;
  }

  static Instance& addWhole(KeyFrame& frame,
                            bool goes,
                            float x = 0.0F,
                            std::uint32_t id = kTrack,
                            std::size_t points = kPoints) {
    frame.evidence->votes.emplace_back();
    Instance& instance = add(frame, id, x, points);
    instance.dynamic = goes;
    return instance;
  }

  /// A part of the instance before, in its midst, that was found to stand.
  static void addPart(KeyFrame& frame) {
    const Instance whole = frame.instances.back();
    Instance& part = add(frame, 1000 + static_cast<std::uint32_t>(frame.index), 0.0F, kPoints / 2);
    part.parent = whole.id;
    part.reason = Reason::kKept;
  }

  /// A frame for each letter: g goes, S stands, . is not seen.
  void addFrames(const std::string& verdicts, float x = 0.0F) {
    for (const char verdict : verdicts) {
      KeyFrame& frame = addFrame();
      if (verdict != '.') addWhole(frame, verdict == 'g', x);
    }
  }

  /// Whether the last instance of a frame goes in the end, when all frames leave together.
  bool goes(std::size_t index) {
    Consensus consensus;
    for (const auto& frame : frames_) consensus.note(*frame);
    for (const auto& frame : frames_) consensus.apply(*frame);
    return frames_[index]->instances.back().dynamic;
  }

  /// The same when each leaves as soon as it can.
  bool goesAmidTheDrive(std::size_t index) {
    Consensus consensus;
    for (std::size_t k = 0; k <= index + kFramesAround; ++k) {
      consensus.note(*frames_[k]);
      if (k >= kFramesAround) consensus.apply(*frames_[k - kFramesAround]);
    }
    return frames_[index]->instances.back().dynamic;
  }

  bool goes(const std::string& verdicts, std::size_t index) {
    frames_.clear();
    addFrames(verdicts);
    return goes(index);
  }

  std::vector<std::unique_ptr<KeyFrame>> frames_;
};

TEST_F(ConsensusTest, WhatAllFramesAroundRemoveGoes) {
  EXPECT_TRUE(goes("gggggSggggg", 5));
  EXPECT_EQ(frames_[5]->instances[0].reason, Reason::kConsensus);
  EXPECT_EQ(frames_[4]->instances[0].reason, Reason::kNoEvidence) << "goes by itself";
}

TEST_F(ConsensusTest, SevenTenthsMustAgree) {
  EXPECT_TRUE(goes("gSgSgSgggSg", 5));
  EXPECT_FALSE(goes("gSgSgSSggSg", 5));
}

TEST_F(ConsensusTest, SixMustHaveSeenIt) {
  EXPECT_TRUE(goes("..gggSggg..", 5));
  EXPECT_FALSE(goes("..gggSgg...", 5));
}

TEST_F(ConsensusTest, WhatStopsStands) {
  EXPECT_FALSE(goes("gggggSS", 5)) << "five of six, none of them after it";
  EXPECT_TRUE(goes("gggggSg", 5));
}

TEST_F(ConsensusTest, WhatStandsIsNotAskedTo) { EXPECT_TRUE(goes("SSSSSgSSSSS", 5)); }

TEST_F(ConsensusTest, FiveFramesToEachSideAreAsked) {
  const std::string verdicts = "SSSSSSgggggSgggggSSSSSSSSSSSS";  // ten of twenty-eight go
  EXPECT_TRUE(goes(verdicts, 11));
  frames_.clear();
  addFrames(verdicts);
  EXPECT_TRUE(goesAmidTheDrive(11));
}

// Verdicts count as they were, so that two beside each other do not hang on their order.
TEST_F(ConsensusTest, WhatFollowedIsNoWitness) {
  EXPECT_TRUE(goes("gggggSSSg", 6)) << "five of seven";
  EXPECT_FALSE(goes("gggggSSSg", 7)) << "four of six by themselves, all with those that follow";
}

TEST_F(ConsensusTest, ElsewhereTellsNothing) {
  addFrames("ggggg", 9.0F);
  addFrames("S", 0.0F);
  addFrames("ggggg", -9.0F);
  EXPECT_FALSE(goes(5));
}

TEST_F(ConsensusTest, WithoutSeeingItAtAllNobodyIsAsked) {
  for (int k = 0; k < 11; ++k) addWhole(addFrame(), k != 5, 0.0F, k == 5 ? kOther : kTrack);
  EXPECT_FALSE(goes(5)) << "another track";
}

TEST_F(ConsensusTest, APartGoesWhenAllOfItGoesAround) {
  addFrames("ggggg");
  addWhole(addFrame(), true);
  addPart(*frames_.back());
  addFrames("ggggg");
  EXPECT_TRUE(goes(5));
}

// A parked car, as one cluster with somebody who passes it.
TEST_F(ConsensusTest, APartThatStandsInFramesAroundStands) {
  for (int k = 0; k < 11; ++k) {
    addWhole(addFrame(), true);
    if (k % 2 == 1) addPart(*frames_.back());
  }
  EXPECT_FALSE(goes(5));
}

// A piece of a parked car has the id of who comes out from behind it.
TEST_F(ConsensusTest, WhereAnotherObjectStandsNothingGoes) {
  for (const std::size_t points : {kPoints / 2 - 1, kPoints / 2}) {
    frames_.clear();
    for (int k = 0; k < 11; ++k) {
      KeyFrame& frame = addFrame();
      if (k != 5) addWhole(frame, false, 3.0F, kOther, points);
      addWhole(frame, k != 5);
    }
    EXPECT_EQ(goes(5), points < kPoints / 2) << points;
  }
}

}  // namespace
}  // namespace segdf

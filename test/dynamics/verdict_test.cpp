// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/verdict.hpp"

#include <gtest/gtest.h>

namespace segdf {
namespace {

/// A vote with `free` of 100 points seen through, from a frame `seconds` away.
PairVote vote(std::uint32_t free, float seconds) { return {0, seconds, free, 100 - free, true}; }

Verdict judge(const std::vector<PairVote>& votes,
              ObjectClass object_class = ObjectClass::kHighMobility) {
  return judgeVotes(votes, object_class, DynamicConfig{});
}

TEST(Verdict, NoVotesAreStatic) {
  const Verdict verdict = judge({});
  EXPECT_FALSE(verdict.dynamic);
  EXPECT_EQ(verdict.pairs, 0U);
}

TEST(Verdict, ThreeVotesRemoveWhatIsSeenByFifteen) {
  std::vector<PairVote> votes(12, vote(0, 1.0F));
  votes.insert(votes.end(), {vote(30, 1.0F), vote(90, 2.0F)});
  EXPECT_FALSE(judge(votes).dynamic) << "two votes";
  votes.push_back(vote(40, 3.0F));
  const Verdict verdict = judge(votes);
  EXPECT_TRUE(verdict.dynamic);
  EXPECT_EQ(verdict.dynamic_votes, 3U);
  EXPECT_EQ(verdict.static_votes, 12U);
  EXPECT_EQ(verdict.needed, 3U);
  EXPECT_FLOAT_EQ(verdict.best, 0.9F);
}

TEST(Verdict, TheShareCountsWhereManyPairsSpeak) {
  std::vector<PairVote> votes(17, vote(0, 1.0F));
  votes.insert(votes.end(), 3, vote(90, 1.0F));
  EXPECT_FALSE(judge(votes).dynamic) << "3 of 20, 4 are needed";
  votes.push_back(vote(90, 1.0F));
  EXPECT_FALSE(judge(votes).dynamic) << "4 of 21, 5 are needed";
  votes.push_back(vote(90, 1.0F));
  EXPECT_TRUE(judge(votes).dynamic);
}

TEST(Verdict, WhatCannotMoveMustBeSeenThroughHalfAsOftenAsFoundAgain) {
  std::vector<PairVote> votes(11, vote(0, 1.0F));
  votes.insert(votes.end(), 5, vote(90, 1.0F));
  EXPECT_TRUE(judge(votes, ObjectClass::kUnknown).dynamic);
  EXPECT_FALSE(judge(votes, ObjectClass::kBuilding).dynamic) << "5 against 11";
  votes.push_back(vote(90, 1.0F));
  EXPECT_TRUE(judge(votes, ObjectClass::kVegetation).dynamic) << "6 against 11";
}

TEST(Verdict, PairsThatSayNothingDoNotCount) {
  PairVote little = vote(90, 1.0F);
  little.informative = false;
  EXPECT_FALSE(judge({little, little, little, little}).dynamic);
}

TEST(Verdict, AtTheEndOfADriveOneClearLongLookIsEnough) {
  // A slow walker: neighbours hit it, and only one frame is far enough to see through.
  const std::vector<PairVote> votes{vote(0, -0.1F), vote(0, 0.1F), vote(0, 0.2F), vote(85, 0.5F)};
  EXPECT_TRUE(judge(votes).dynamic);
  const std::vector<PairVote> doubtful{vote(0, -0.1F), vote(0, 0.1F), vote(0, 0.2F),
                                       vote(60, 0.5F)};
  EXPECT_FALSE(judge(doubtful).dynamic);
  const std::vector<PairVote> outvoted{vote(0, -1.0F), vote(0, 1.0F), vote(85, 0.5F)};
  EXPECT_FALSE(judge(outvoted).dynamic) << "three long looks decide by votes";
}

TEST(Parked, FoundAgainForTheMostPartByThreeDistantFrames) {
  const std::vector<PairVote> found(3, vote(0, 2.0F));
  EXPECT_TRUE(isParked(found, 150, DynamicConfig{}));
  EXPECT_FALSE(isParked(found, 300, DynamicConfig{})) << "a third of it only";
  EXPECT_FALSE(isParked({vote(0, 0.2F), vote(0, 0.2F), vote(0, 2.0F)}, 100, DynamicConfig{}))
      << "what moves slowly is found again by neighbours";
}

constexpr std::size_t kAll = 100;  // points

TEST(CameHere, WhatALookFiveSecondsBeforeSawThrough) {
  EXPECT_TRUE(cameHere({vote(98, -5.0F), vote(0, -3.0F), vote(0, 2.0F)}, kAll, {}));
  EXPECT_FALSE(cameHere({vote(98, -4.9F), vote(0, 2.0F)}, kAll, {}));
  EXPECT_FALSE(cameHere({vote(98, 5.0F)}, kAll, {})) << "it left";
  EXPECT_FALSE(cameHere({}, kAll, {}));
}

TEST(CameHere, NearlyAllThatWasLookedAtMustHaveBeenSeenThrough) {
  EXPECT_FALSE(cameHere({vote(97, -5.0F)}, kAll, {}));
}

TEST(CameHere, HalfOfItMustHaveBeenLookedAt) {
  EXPECT_TRUE(cameHere({{0, -5.0F, 50, 0, true}}, kAll, {}));
  EXPECT_FALSE(cameHere({{0, -5.0F, 49, 0, true}}, kAll, {}));
}

TEST(CameHere, NothingComesToWhereItWasFoundBefore) {
  EXPECT_FALSE(cameHere({vote(100, -5.0F), vote(0, -6.0F)}, kAll, {}));
  EXPECT_TRUE(cameHere({vote(100, -5.0F), vote(100, -6.0F)}, kAll, {}));
}

TEST(CameHere, AFewPointsMayBeTheEdgeOfADarkCar) {
  const PairVote clear{0, -5.0F, 30, 0, true};
  EXPECT_TRUE(cameHere({clear}, 30, {}));
  EXPECT_FALSE(cameHere({clear}, 29, {}));
}

}  // namespace
}  // namespace segdf

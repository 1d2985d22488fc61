// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/track_vote.hpp"

#include "support/track_frames.hpp"

namespace segdf {
namespace {

using test::kCar;
using test::kPoints;
using test::TrackVote;

TEST_F(TrackVote, WhatStoppedGoesAfterThreeQuartersOfASecondOfMotionAtTenHertz) {
  for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
  addStanding(8.0, 0.1);
  EXPECT_TRUE(goes());
}

TEST_F(TrackVote, LessMotionDoesNotOutweighThatItStands) {
  for (int k = 0; k < 7; ++k) addMoving(1.0 * k, 0.1);
  addStanding(8.0, 0.1);
  EXPECT_FALSE(goes());
}

TEST_F(TrackVote, ThreeKeyFramesByWayAreAsGoodAsEightScans) {
  for (int k = 0; k < 3; ++k) addMoving(3.0 * k, 0.3);
  addStanding(9.0, 0.3);
  EXPECT_TRUE(goes());
}

TEST_F(TrackVote, TwoAreNeverEnoughHoweverFarApart) {
  for (int k = 0; k < 2; ++k) addMoving(3.0 * k, 5.0);
  addStanding(9.0, 5.0);
  EXPECT_FALSE(goes());
}

TEST_F(TrackVote, WhatCreptOnAsAWholeNeedsNoCarLengthForIt) {
  for (int k = 0; k < 10; ++k) addMoving(6.8, 0.1);
  addStanding(8.0, 0.1);
  EXPECT_TRUE(goes());
}

// A car passes one that is parked, hides it until the drive ends, and takes its id along.
TEST_F(TrackVote, WhatNobodySawLeaveStays) {
  KeyFrame& parked = addStanding(0.0, 0.1, 0);
  for (int k = 0; k < 9; ++k) addMoving(3.0 + k, 0.1);
  TrackBook(config_).propagate(window_, 0);
  EXPECT_FALSE(parked.instances[0].dynamic);
  parked.evidence->votes[0].push_back({3, 0.3F, kPoints, 0, true});
  TrackBook(config_).propagate(window_, 0);
  EXPECT_TRUE(parked.instances[0].dynamic) << "it drove off";
}

TEST_F(TrackVote, WhoSawThroughItBeforeItsTrackMovedDidNotSeeItLeave) {
  addStanding(0.0, 0.1, 0);
  KeyFrame& parked = addStanding(0.0, 0.1, 0);
  parked.evidence->votes[0].push_back({0, -0.1F, kPoints, 0, true});
  for (int k = 0; k < 9; ++k) addMoving(3.0 + k, 0.1);
  TrackBook(config_).propagate(window_, 1);
  EXPECT_FALSE(parked.instances[0].dynamic);
}

TEST_F(TrackVote, WhoRidesBeforeAHedgeDoesNotTakeItAlong) {
  const Eigen::Vector3f rider(1.8F, 0.6F, 1.7F);
  for (int k = 0; k < 20; ++k) addMoving(1.0 * k, 0.1, rider);
  KeyFrame& hedge = addStanding(24.0, 0.1);
  hedge.seg.segments[0].object_class = ObjectClass::kVegetation;
  EXPECT_FALSE(goes());
  hedge.instances[0].dynamic = false;
  hedge.seg.segments[0].object_class = ObjectClass::kUnknown;
  EXPECT_TRUE(goes());
}

// The rear of a car that drives off, at the end of a drive.
TEST_F(TrackVote, APartOfWhatMovedGoesWhenHardlyAnyFoundItAgain) {
  const Eigen::Vector3f rear(0.4F, 0.3F, 0.6F);
  for (int k = 0; k < 7; ++k) addMoving(1.0 * k, 0.1);
  add(7.0, rear, 0.1);
  EXPECT_FALSE(goes()) << "0.7 s of motion";
  addMoving(8.0, 0.1);
  add(9.0, rear, 0.1);
  EXPECT_TRUE(goes());
  addStanding(9.0, 0.1).seg.segments[0].box.size = rear;
  EXPECT_FALSE(goes()) << "a bollard that the car has driven by";
}

TEST_F(TrackVote, OfWhatStandsBesideTheSensorASideIsSeen) {
  const Eigen::Vector3f lorry(8.0F, 2.5F, 3.4F);
  for (int k = 0; k < 8; ++k) addMoving(3.0 * k, 0.1, lorry);
  addStanding(24.0, 0.1).seg.segments[0].box.size = Eigen::Vector3f(7.7F, 1.0F, 2.2F);
  EXPECT_TRUE(goes());
  addStanding(24.0, 0.1);
  EXPECT_FALSE(goes()) << "a parked car that the lorry has driven by";
}

TEST_F(TrackVote, WhatMovedElsewhereAtItsSizeIsWhole) {
  for (double x : {0.0, 8.0}) {
    for (int k = 0; k < 8; ++k) addMoving(x - 1.0 + 0.1 * k, 0.1);
    addMoving(8.0, 0.1);
    makeDynamic(*window_.back());
    TrackBook(config_).propagate(window_, window_.size() - 1);
    EXPECT_EQ(frames_.back()->instances[0].whole, x == 0.0) << x;
    window_.clear();
  }
}

TEST_F(TrackVote, WhatWasLostForHalfASecondIsTheSame) {
  for (double gap : {0.4, 0.6}) {
    TrackBook tracks(config_);
    moveThroughTheWindow(tracks);
    add(50.0, kCar, gap).instances[0].id = 9;
    tracks.note(*frames_.back());
    window_.clear();
    addStanding(8.0, 0.05);
    tracks.propagate(window_, 0);
    EXPECT_EQ(frames_.back()->instances[0].dynamic, gap < 0.5) << gap;
    window_.clear();
  }
}

TEST_F(TrackVote, AtTheEndOfADriveNoProofCountsTwice) {
  for (int k = 0; k < 4; ++k) addMoving(2.0 * k, 0.1);
  addStanding(8.0, 0.1);
  TrackBook tracks(config_);
  for (std::size_t k = 0; k + 1 < window_.size(); ++k) {
    makeDynamic(*window_[k]);
    tracks.propagate(window_, k);
    tracks.note(*window_[k]);
  }
  tracks.propagate(window_, window_.size() - 1);
  EXPECT_FALSE(frames_.back()->instances[0].dynamic);
}

TEST_F(TrackVote, OneMemberOfManyThatTheVotesMakeDynamicIsRestored) {
  for (int k = 0; k < 10; ++k) addStanding(8.0, 0.1);
  addMoving(8.0, 0.1);
  frames_.back()->instances[0].dynamic = true;
  EXPECT_FALSE(goes());
  EXPECT_EQ(frames_.back()->instances[0].reason, Reason::kRestored);
}

TEST_F(TrackVote, OfFewMembersNoneIsRestored) {
  for (int k = 0; k < 6; ++k) addStanding(8.0, 0.1);
  addMoving(8.0, 0.1);
  frames_.back()->instances[0].dynamic = true;
  EXPECT_TRUE(goes());
}

TEST_F(TrackVote, WhatMovedBeforeTheWindowIsNotRestored) {
  TrackBook tracks(config_);
  moveThroughTheWindow(tracks);
  addMoving(8.0, 0.1);
  KeyFrame& last_that_moved = *frames_.back();
  last_that_moved.instances[0].dynamic = true;
  for (int k = 0; k < 30; ++k) addStanding(8.0, 0.1);
  tracks.propagate(window_, 0);
  EXPECT_TRUE(last_that_moved.instances[0].dynamic);
}

TEST_F(TrackVote, WhatLeftTheWindowIsRemembered) {
  TrackBook tracks(config_);
  moveThroughTheWindow(tracks);
  addStanding(8.0, 0.1);
  tracks.propagate(window_, 0);
  EXPECT_TRUE(frames_.back()->instances[0].dynamic);
}

/// It stands where a scan 6 s before saw nothing, and nobody knows of any motion.
class TrackCame : public TrackVote {
 protected:
  KeyFrame& addCame() {
    KeyFrame& frame = addStanding(0.0, 0.1);
    frame.seg.segments[0].points.resize(40);
    for (PairVote& found : frame.evidence->votes[0]) found.hit = 40;
    frame.evidence->votes[0].push_back({0, -6.0F, 40, 0, true});
    return frame;
  }
};

TEST_F(TrackCame, WhatCameAndStandsGoesThoughNobodySawItMove) {
  const KeyFrame& frame = addCame();
  EXPECT_TRUE(goes());
  EXPECT_EQ(frame.instances[0].reason, Reason::kLongLook);
}

TEST_F(TrackCame, NotWhatIsKeptWhileItIsParked) {
  config_.semi_static = SemiStatic::kKeepWhileParked;
  addCame();
  EXPECT_FALSE(goes());
}

TEST_F(TrackCame, NotWhatCannotMove) {
  addCame().seg.segments[0].object_class = ObjectClass::kVegetation;
  EXPECT_FALSE(goes());
  addCame().seg.segments[0].box.size.x() = 25.0F;
  EXPECT_FALSE(goes());
}

TEST_F(TrackCame, ItProvesNoMotionOfItsId) {
  for (int k = 0; k < 12; ++k) addCame();
  TrackBook tracks(config_);
  for (std::size_t k = 0; k < window_.size(); ++k) {
    tracks.propagate(window_, k);
    tracks.note(*window_[k]);
  }
  window_.clear();
  addStanding(0.0, 0.1);
  tracks.propagate(window_, 0);
  EXPECT_FALSE(frames_.back()->instances[0].dynamic);
}

}  // namespace
}  // namespace segdf

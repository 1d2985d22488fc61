// SPDX-License-Identifier: BSD-3-Clause
// What stands where the id of something that moves is found, and is another object.
#include "segdf/dynamics/track_vote.hpp"

#include "support/track_frames.hpp"

namespace segdf {
namespace {

using test::kPoints;
using test::TrackVote;

class TrackApart : public TrackVote {
 protected:
  /// Three scans in which the track was lost.
  void addLost() {
    for (int k = 0; k < 3; ++k) addStanding(50.0, 0.1).instances[0].id = 9;
  }

  /// Something moves for 0.8 s, and stops. Three scans in which its track was lost found it again
  /// where it stops. @param hit points of the 20. @param amid in the midst of its motion, or before
  bool goesWhenFound(std::uint32_t hit, bool amid) {
    window_.clear();
    std::size_t lost = frames_.size();
    if (!amid) addLost();
    for (int k = 0; k < 4; ++k) addMoving(1.0 * k, 0.1);
    if (amid) {
      lost = frames_.size();
      addLost();
    }
    for (int k = 4; k < 8; ++k) addMoving(1.0 * k, 0.1);
    for (PairVote& vote : addStanding(8.0, 0.1, lost).evidence->votes[0]) vote.hit = hit;
    return goes();
  }

  /// Something moves for 0.8 s, and stops. Two scans found it again where it stops. @param scan of
  /// the first of these @param seen_through by another scan
  bool goesWhenFoundTwice(std::size_t scan, bool seen_through) {
    window_.clear();
    const std::size_t first = frames_.size();
    for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
    std::vector<PairVote>& votes = addStanding(8.0, 0.1, first + scan).evidence->votes[0];
    votes.back().scan = 100;
    if (seen_through) votes.push_back({first, 0.8F, kPoints, 0, true});
    return goes();
  }
};

TEST_F(TrackApart, WhatWasFoundHereWhileTheTrackMovedElsewhereIsAnotherObject) {
  for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
  addStanding(8.0, 0.1, 2);
  EXPECT_FALSE(goes());
}

// Of a car that brakes the front already is, two scans a second, where the car will stand.
TEST_F(TrackApart, OfKeyFramesFarApartTwoSuchScansSay) {
  for (int k = 0; k < 3; ++k) addMoving(3.0 * k, 0.3);
  addStanding(9.0, 0.3, 2);
  EXPECT_TRUE(goes());
  frames_.back()->instances[0].dynamic = false;
  frames_.back()->evidence->votes[0].front().scan = 1;
  frames_.back()->evidence->votes[0].back().scan = 2;
  EXPECT_FALSE(goes());
}

// Pieces of parked cars behind a cyclist are a part of him, and his track ends at one of them. Few
// of the scans in which he was elsewhere were looked back to.
TEST_F(TrackApart, TwoSuchScansSayIfItHadNoPlaceInCommonAndNoneSawThroughIt) {
  EXPECT_FALSE(goesWhenFoundTwice(2, false)) << "5 and 6 m away, and 4.2 m long";
  EXPECT_TRUE(goesWhenFoundTwice(2, true));
  EXPECT_TRUE(goesWhenFoundTwice(4, false)) << "3 and 4 m away: it brakes";
}

TEST_F(TrackApart, AViewOfABusIsAsFarFromItsCentreAsTheBusIsLong) {
  const Eigen::Vector3f bus(11.5F, 2.5F, 3.0F);
  for (int k = 0; k < 8; ++k) addMoving(-30.0 + k, 0.1);
  for (int k = 0; k < 3; ++k) addMoving(5.0, 0.1, bus);
  addStanding(0.0, 0.1, 8);
  EXPECT_TRUE(goes()) << "its rear was found again where it stood all the time";
}

// A cyclist passes a parked car closely and takes its id along.
TEST_F(TrackApart, WhatIsFoundAgainAfterTheTrackHasMovedOnIsAnotherObject) {
  KeyFrame& parked = addStanding(0.0, 0.1, 9);  // the first of its three is among the proofs
  for (int k = 0; k < 9; ++k) addMoving(3.0 + k, 0.1);
  TrackBook(config_).propagate(window_, 0);
  EXPECT_FALSE(parked.instances[0].dynamic);
}

TEST_F(TrackApart, AfterThreeTimesTheTracksMotionCountsNoMore) {
  for (int others : {2, 3}) {
    for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
    const std::size_t moving = frames_.size() - 6;
    for (int k = 0; k < others; ++k) addStanding(8.0, 0.1, moving);
    addStanding(8.0, 0.1, 1000);  // nobody who looked knows that it is another
    TrackBook tracks(config_);
    for (std::size_t k = 8; k < window_.size(); ++k) tracks.propagate(window_, k);
    EXPECT_EQ(frames_.back()->instances[0].dynamic, others == 2) << others;
    window_.clear();
  }
}

TEST_F(TrackApart, NotIfOneSawThroughItOnceTheTrackWasGone) {
  KeyFrame& leaving = addStanding(0.0, 0.1, 9);
  leaving.evidence->votes[0].push_back({8, 0.8F, kPoints, 0, true});
  for (int k = 0; k < 9; ++k) addMoving(3.0 + k, 0.1);
  TrackBook(config_).propagate(window_, 0);
  EXPECT_TRUE(leaving.instances[0].dynamic) << "another car stands in its place now";
}

// A car parks. Seconds later somebody hides it, and its id passes on to its neighbour.
TEST_F(TrackApart, WhatCameAndStoppedGoesWhereverItsIdIsLater) {
  for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
  KeyFrame& parked = addStanding(8.0, 0.1, 9);
  for (int k = 0; k < 3; ++k) addStanding(14.0, 0.1);
  TrackBook(config_).propagate(window_, 8);
  EXPECT_TRUE(parked.instances[0].dynamic);
}

// While it brakes a part of it is where it will stand.
TEST_F(TrackApart, WhatWasFoundAsAWholeAmidTheMotionIsAnotherObject) {
  EXPECT_TRUE(goesWhenFound(17, true));
  EXPECT_FALSE(goesWhenFound(18, true)) << "nine tenths";
}

TEST_F(TrackApart, BeforeAllMotionAHalfIsEnough) {
  EXPECT_TRUE(goesWhenFound(9, false));
  EXPECT_FALSE(goesWhenFound(10, false));
}

}  // namespace
}  // namespace segdf

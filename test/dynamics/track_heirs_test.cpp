// SPDX-License-Identifier: BSD-3-Clause
// What an id that is new, or has ended, did counts for others.
#include "segdf/dynamics/track_vote.hpp"

#include "support/track_frames.hpp"

namespace segdf {
namespace {

using test::TrackVote;

class TrackHeirs : public TrackVote {};

TEST_F(TrackHeirs, WhatCameOffAMoverInheritsItsMotion) {
  for (int k = 0; k < 8; ++k) addMoving(1.0 * k, 0.1);
  KeyFrame& frame = addStanding(8.0, 0.1);
  frame.instances[0].id = 8;
  EXPECT_FALSE(goes());
  frame.instances[0].parent = 7;
  EXPECT_TRUE(goes());
}

TEST_F(TrackHeirs, WhatCameOffAMoverDoesNotInheritItsLaterMotion) {
  KeyFrame& first = addStanding(8.0, 0.1);
  first.instances[0].id = 8;
  first.instances[0].parent = 7;
  for (int k = 0; k < 8; ++k) addMoving(9.0 + k, 0.1);
  TrackBook(config_).propagate(window_, 0);
  EXPECT_FALSE(first.instances[0].dynamic);
}

TEST_F(TrackHeirs, WhatIsInheritedOutlastsTheWindow) {
  TrackBook tracks(config_);
  moveThroughTheWindow(tracks);
  for (int k = 0; k < 2; ++k) {
    KeyFrame& frame = addStanding(8.0, 0.1);
    frame.instances[0].id = 8 + static_cast<std::uint32_t>(k);
    frame.instances[0].parent = 7 + static_cast<std::uint32_t>(k);
    tracks.propagate(window_, 0);
    EXPECT_TRUE(frame.instances[0].dynamic);
    tracks.note(frame);
    window_.clear();
  }
}

// A car parks; a lorry drives by, and of what its rear uncovers bit by bit, the id goes from the
// car that has parked to the one in front of it, which stood there all the while.
TEST_F(TrackHeirs, WhatStoodWhileTheTrackStoodElsewhereStays) {
  for (std::uint32_t id : {7U, 8U}) {
    for (bool stood : {true, false}) {
      TrackBook tracks(config_);
      moveThroughTheWindow(tracks);
      const std::size_t parked = frames_.size();
      for (int k = 0; k < 3; ++k) {
        addStanding(8.0, 0.1);
        tracks.propagate(window_, 0);
        EXPECT_TRUE(frames_.back()->instances[0].dynamic) << "it came, and parked";
        tracks.note(*frames_.back());
        window_.clear();
      }
      KeyFrame& other = addStanding(14.0, 0.1, stood ? parked : 100);
      other.instances[0].id = id;
      if (id != 7) other.instances[0].parent = 7;
      tracks.propagate(window_, 0);
      EXPECT_EQ(other.instances[0].dynamic, !stood) << id;
      window_.clear();
    }
  }
}

// A car that came and stopped is half hidden by one that passes: a piece at its end has its id
// then.
TEST_F(TrackHeirs, APieceAtItsEndIsNoOtherPlace) {
  for (double x : {11.7, 11.5}) {
    TrackBook tracks(config_);
    moveThroughTheWindow(tracks);
    const std::size_t hidden = frames_.size();
    for (int k = 0; k < 3; ++k) {
      addStanding(x, 0.1).seg.segments[0].box.size = Eigen::Vector3f(0.5F, 0.5F, 0.5F);
      tracks.note(*frames_.back());
      window_.clear();
    }
    KeyFrame& whole = addStanding(14.0, 0.1, hidden);
    tracks.propagate(window_, 0);
    // Half of both lengths together is 2.35 m.
    EXPECT_EQ(whole.instances[0].dynamic, x == 11.7) << x;
    window_.clear();
  }
}

// A car drives close by another that is parked, and leaves its id with it. As long as scans from
// before it came are compared, they found the parked one; its heirs know that later, too.
TEST_F(TrackHeirs, WhatTheIdWasFoundToStandAsIsInherited) {
  for (int known : {3, 2}) {
    TrackBook tracks(config_);
    const std::size_t moved = frames_.size();
    moveThroughTheWindow(tracks);
    for (int k = 0; k < known; ++k) {
      KeyFrame& parked = addStanding(14.0, 0.1, moved);
      tracks.propagate(window_, 0);
      EXPECT_FALSE(parked.instances[0].dynamic)
          << "scans in which the track moved elsewhere saw it";
      tracks.note(parked);
      window_.clear();
    }
    KeyFrame& heir = addStanding(14.0, 0.1);
    heir.instances[0].id = 8;
    heir.instances[0].parent = 7;
    tracks.propagate(window_, 0);
    EXPECT_EQ(heir.instances[0].dynamic, known < 3);
    window_.clear();
  }
}

// A cyclist, and the parked car that was one cluster with him and has the id now.
TEST_F(TrackHeirs, WhatAStandingPartWasTakenOutOfProvesNothingUnlessItIsHigh) {
  for (float height : {1.5F, 3.0F}) {
    for (std::size_t stood : {5U, 4U}) {  // of these and 20
      TrackBook tracks(config_);
      for (int k = 0; k < 8; ++k) {
        KeyFrame& frame = addMoving(1.0 * k, 0.1, {4.2F, 1.8F, height});
        makeDynamic(frame);
        frame.seg.segments.resize(2);
        frame.seg.segments[1].points.resize(stood);
        frame.instances.resize(2);
        frame.instances[1].parent = 7;
        frame.instances[1].reason = Reason::kKept;
        tracks.note(frame);
        window_.clear();
      }
      addStanding(8.0, 0.1);
      tracks.propagate(window_, 0);
      EXPECT_EQ(frames_.back()->instances[0].dynamic, height > 2.2F || stood == 4) << stood;
      window_.clear();
    }
  }
}

/// What moved had another id in each scan, and then stood.
class ChangingIds : public TrackVote {
 protected:
  /// @param step metres from one scan to the next. @param last id with which it stands
  bool stopsAfter(double step, std::uint32_t last) {
    TrackBook tracks(config_);
    for (std::uint32_t k = 0; k < 4; ++k) {
      addMoving(step * k, 0.3).instances[0].id = 10 + k;
      decide(tracks);
    }
    addStanding(4.0 * step, 0.3).instances[0].id = last;
    decide(tracks);
    return frames_.back()->instances[0].dynamic;
  }

  /// A second instance, of which nobody saw anything.
  static void addBeside(KeyFrame& frame, double x, std::uint32_t id) {
    frame.seg.segments.push_back(frame.seg.segments[0]);
    frame.seg.segments[1].box.center.x() = static_cast<float>(x);
    frame.instances.resize(2);
    frame.instances[1].id = id;
    frame.evidence->votes.resize(2);
  }

  void decide(TrackBook& tracks) {
    KeyFrame& frame = *window_.back();
    if (frame.evidence->votes[0].front().free > 0) makeDynamic(frame);
    tracks.propagate(window_, 0);
    tracks.note(frame);
    window_.clear();
  }
};

TEST_F(ChangingIds, WhatMovesGoesOnWithWhatEndedWhereItBegins) { EXPECT_TRUE(stopsAfter(2.0, 13)); }

TEST_F(ChangingIds, NotFartherThanOneStep) { EXPECT_FALSE(stopsAfter(3.0, 13)); }

TEST_F(ChangingIds, WhatStandsIsNobodysHeir) { EXPECT_FALSE(stopsAfter(2.0, 14)); }

TEST_F(ChangingIds, NorIsWhatWasThereForMoreThanHalfASecond) {
  for (int since : {1, 3, 8}) {
    TrackBook tracks(config_);
    for (int k = 0; k < 8; ++k) {
      KeyFrame& frame = addMoving(1.0 * k, 0.1);
      if (k >= since) addBeside(frame, 9.0, 20);
      decide(tracks);
    }
    addMoving(9.0, 0.02).instances[0].id = 20;
    decide(tracks);
    addStanding(9.0, 0.1).instances[0].id = 20;
    decide(tracks);
    EXPECT_EQ(frames_.back()->instances[0].dynamic, since > 1) << since;
  }
}

// A walker and a parked car are one cluster with the car's id, and the walker's has ended.
TEST_F(ChangingIds, NorIsWhatStoodBesideIt) {
  for (bool stood : {false, true}) {
    TrackBook tracks(config_);
    for (int k = 0; k < 8; ++k) {
      KeyFrame& frame = addMoving(1.0 * k, 0.1);
      if (k >= 5) addBeside(frame, 9.0, 20);
      if (k >= 5 && stood) frame.evidence->votes[1].assign(3, {100, 1.0F, 0, test::kPoints, true});
      decide(tracks);
    }
    addMoving(9.0, 0.02).instances[0].id = 20;
    decide(tracks);
    addStanding(9.0, 0.1).instances[0].id = 20;
    decide(tracks);
    EXPECT_EQ(frames_.back()->instances[0].dynamic, !stood);
  }
}

TEST_F(ChangingIds, WhatTwoHaveFromOneCountsOnce) {
  for (int moved : {4, 6}) {
    TrackBook tracks(config_);
    for (int k = 0; k < moved; ++k) {
      addMoving(1.0 * k, 0.1);
      decide(tracks);
    }
    for (std::uint32_t id : {8U, 9U}) {
      Instance& child = addMoving(1.0 * moved, 0.1).instances[0];
      child.id = id;
      child.parent = 7;
      decide(tracks);
    }
    addStanding(1.0 * moved, 0.1).instances[0].id = 9;
    decide(tracks);
    EXPECT_EQ(frames_.back()->instances[0].dynamic, moved == 6) << "0.6 s and 0.8 s of motion";
  }
}

}  // namespace
}  // namespace segdf

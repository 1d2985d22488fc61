// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/departure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/verdict.hpp"

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

constexpr std::uint32_t kId = 7;
constexpr std::size_t kScans = 11;
constexpr double kStep = 0.1;     // seconds
constexpr double kSpeed = 5.5;    // m/s
constexpr double kAcross = 30.0;  // metres ahead
// Nothing returns from beyond but what stands there.
constexpr double kRoadEnd = 24.0;  // metres ahead

/// A car and nothing behind it, as the same sensor, which stands, sees it in a second.
class DepartureTest : public ::testing::Test {
 protected:
  using Way = std::function<Eigen::Vector2d(double)>;

  /// @param way where the car is at which second @param late stands in the last scan, too
  void see(const Way& way, const std::vector<test::Box>& late = {}) {
    for (std::size_t k = 0; k < kScans; ++k) {
      const double seconds = kStep * static_cast<double>(k);
      const Eigen::Vector2d place = way(seconds);
      test::BoxWorld world;
      world.add(place.x(), place.y(), 1.8, 4.2, 1.5);
      if (k + 1 == kScans) addAll(late, world);
      add(withoutFarRoad(world.scan(0.0, 0.0, 0.0, std::llround(1e9 * seconds) + 1)), place);
    }
    noteDepartures(window_, {{0, Pose::Identity()}});
  }

  static void addAll(const std::vector<test::Box>& boxes, test::BoxWorld& world) {
    for (const test::Box& box : boxes) {
      world.add(box.center.x(), box.center.y(), box.size.x(), box.size.y(), box.size.z());
    }
  }

  /// What of the road lies far away returns nothing.
  static Scan withoutFarRoad(Scan scan) {
    const auto is_far_road = [](const Point& p) {
      return static_cast<double>(p.x) > kRoadEnd && p.z < -1.6F;
    };
    auto& points = scan.points;
    points.erase(std::remove_if(points.begin(), points.end(), is_far_road), points.end());
    return scan;
  }

  void add(Scan scan, const Eigen::Vector2d& place) {
    std::unique_ptr<KeyFrame> frame = test::makeKeyFrame(std::move(scan), config_);
    frame->index = window_.size();
    const std::size_t car = test::segmentAt(*frame, place.x(), place.y());
    for (std::size_t s = 0; s < frame->instances.size(); ++s) {
      frame->instances[s].id = s == car ? kId : next_id_++;
    }
    frame->evidence = std::make_shared<FrameEvidence>(prepareEvidence(*frame, config_.df));
    listPlaces(*frame);
    window_.push_back(frame.get());
    frames_.push_back(std::move(frame));
  }

  /// Of the car in the frame.
  const std::vector<PairVote>& votes(const KeyFrame& frame) const {
    const auto car = std::find_if(frame.instances.begin(), frame.instances.end(),
                                  [](const Instance& instance) { return instance.id == kId; });
    return frame.evidence->votes[static_cast<std::size_t>(car - frame.instances.begin())];
  }
  const std::vector<PairVote>& firstVotes() const { return votes(*window_.front()); }
  const std::vector<PairVote>& lastVotes() const { return votes(*window_.back()); }

  static Eigen::Vector2d drivesBy(double seconds) { return {kAcross, kSpeed * (seconds - 0.5)}; }

  Config config_;
  std::vector<std::unique_ptr<KeyFrame>> frames_;
  Window window_;
  std::uint32_t next_id_ = 100;
};

TEST_F(DepartureTest, WhoDrivesByBeforeNothingLeftHisPlace) {
  see(drivesBy);
  ASSERT_EQ(firstVotes().size(), 1U);
  const PairVote& vote = firstVotes().front();
  EXPECT_TRUE(vote.departure);
  EXPECT_TRUE(vote.informative);
  EXPECT_EQ(vote.scan, kScans - 1);
  EXPECT_NEAR(vote.seconds, 1.0, 1e-6);
  EXPECT_EQ(vote.hit, 0U);
  const Verdict verdict = judgeVotes(firstVotes(), ObjectClass::kHighMobility, config_.df);
  EXPECT_TRUE(verdict.dynamic);
  EXPECT_EQ(verdict.reason, Reason::kDeparture);
  EXPECT_EQ(lastVotes().size(), 1U) << "and nobody was there before he came";
}

TEST_F(DepartureTest, WithoutItNobodySeesThroughThePlace) {
  see(drivesBy);
  KeyFrame& first = *frames_.front();
  first.evidence->votes.assign(first.instances.size(), {});
  gatherEvidence(first, *frames_.back(), Pose::Identity(), config_.df, 1);
  for (const PairVote& vote : firstVotes()) EXPECT_FALSE(isSeenThrough(vote, config_.df));
}

TEST_F(DepartureTest, WhoStandsIsThere) {
  see([](double) { return Eigen::Vector2d(kAcross, 2.75); });
  EXPECT_TRUE(firstVotes().empty());
  EXPECT_TRUE(lastVotes().empty());
}

TEST_F(DepartureTest, AnIdThatJumpsIsOfAnother) {
  see([](double seconds) { return Eigen::Vector2d(kAcross, seconds < 0.5 ? -2.75 : 2.75); });
  EXPECT_TRUE(firstVotes().empty());
}

TEST_F(DepartureTest, WhatIsHiddenMayStillBeThere) {
  test::Box lorry;
  lorry.center = {20.0, drivesBy(0.0).y(), 0.0};
  lorry.size = {2.0, 4.5, 3.0};
  see(drivesBy, {lorry});
  EXPECT_TRUE(firstVotes().empty());
  EXPECT_EQ(lastVotes().size(), 1U) << "hidden later, not before";
}

TEST_F(DepartureTest, FartherAwayThanItIsSeenNothingMayReturn) {
  see([](double seconds) { return Eigen::Vector2d(kAcross + 5.0 - 7.0 * seconds, 4.0); });
  EXPECT_TRUE(firstVotes().empty());
  EXPECT_EQ(lastVotes().size(), 1U) << "where it came to was nearer to see";
}

TEST_F(DepartureTest, WhatIsLowGoesAlongWithTheRaysThatMeetIt) {
  see(drivesBy);
  for (const auto& frame : frames_) {
    frame->evidence->votes.assign(frame->instances.size(), {});
    for (Segment& segment : frame->seg.segments) segment.features[Feature::kTop] = 0.3F;
  }
  noteDepartures(window_, {{0, Pose::Identity()}});
  EXPECT_TRUE(firstVotes().empty());
}

}  // namespace
}  // namespace segdf

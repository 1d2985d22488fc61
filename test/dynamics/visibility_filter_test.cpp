// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/visibility_filter.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "segdf/pipeline/pipeline.hpp"

#include "support/box_world.hpp"
#include "support/flushed.hpp"

namespace segdf {
namespace {

constexpr std::int64_t kTenth = 100000000;  // nanoseconds

/// A drive of 0.8 m a scan along a street, 10 scans a second, with one box that is placed for each
/// scan.
class VisibilityFilterTest : public ::testing::Test {
 protected:
  /// @param place of the box, 1.5 m high, at scan k
  template <class Place>
  void drive(std::size_t scans, double length, double width, const Place& place) {
    test::BoxWorld world = test::makeStreet();
    parked_ = world.add(14.0, 5.0, 4.2, 1.8, 1.5);
    const std::size_t box = world.add(0.0, 0.0, length, width, 1.5);
    Pipeline pipeline(config_, 1);
    for (std::size_t k = 0; k < scans; ++k) {
      places_.push_back(place(static_cast<double>(k)));
      world.moveTo(box, places_.back().x(), places_.back().y());
      const auto stamp = static_cast<std::int64_t>(k + 1) * kTenth;
      collect(pipeline.process(world.scan(0.8 * static_cast<double>(k), 0.0, 0.0, stamp, 600)));
    }
    collect(test::flushed(pipeline));
  }

  void collect(std::vector<FrameResult> results) {
    for (FrameResult& result : results) frames_.push_back(std::move(result));
  }

  /// Share of the points of a box, from its feet up, that were removed over the whole drive.
  template <class CenterOf>
  double removedOf(const CenterOf& center_of, double length, double width) const {
    double points = 0.0;
    double removed = 0.0;
    for (const FrameResult& frame : frames_) {
      const Eigen::Vector2d center = center_of(frame.index);
      for (std::size_t i = 0; i < frame.labels.size(); ++i) {
        const Eigen::Vector3d x = frame.scan.pose * frame.scan.points[i].position().cast<double>();
        if (x.z() < 0.05 || std::abs(x.x() - center.x()) > length / 2.0 + 0.05) continue;
        if (std::abs(x.y() - center.y()) > width / 2.0 + 0.05) continue;
        points += 1.0;
        removed += frame.labels[i].state == PointState::kDynamic ? 1.0 : 0.0;
      }
    }
    return points > 0.0 ? removed / points : -1.0;
  }

  double moverRemoved(double length, double width) const {
    return removedOf([this](std::size_t k) { return places_[k]; }, length, width);
  }
  double parkedRemoved() const {
    return removedOf([](std::size_t) { return Eigen::Vector2d(14.0, 5.0); }, 4.2, 1.8);
  }

  Config config_;
  std::size_t parked_ = 0;
  std::vector<Eigen::Vector2d> places_;
  std::vector<FrameResult> frames_;
};

// The scenes have no noise: what is not removed of a mover is in clusters too small to be judged,
// what is removed of something that stands is a plain error.
constexpr double kNearlyAll = 0.95;

TEST_F(VisibilityFilterTest, RemovesAnOncomingCarAndKeepsTheParkedOne) {
  drive(20, 4.2, 1.8, [](double k) { return Eigen::Vector2d(40.0 - k, -3.0); });
  EXPECT_GT(moverRemoved(4.2, 1.8), kNearlyAll);
  EXPECT_EQ(parkedRemoved(), 0.0);
}

TEST_F(VisibilityFilterTest, RemovesACarThatKeepsItsDistance) {
  drive(20, 4.2, 1.8, [](double k) { return Eigen::Vector2d(12.0 + 0.8 * k, 0.0); });
  EXPECT_GT(moverRemoved(4.2, 1.8), kNearlyAll);
  EXPECT_EQ(parkedRemoved(), 0.0);
}

TEST_F(VisibilityFilterTest, RemovesAWalkerWhoMovesLessThanACellFromScanToScan) {
  drive(20, 0.5, 0.5, [](double k) { return Eigen::Vector2d(16.0, -4.0 + 0.14 * k); });
  EXPECT_GT(moverRemoved(0.5, 0.5), kNearlyAll);
}

TEST_F(VisibilityFilterTest, KeepsWhatStandsThroughTheWholeDrive) {
  drive(20, 4.2, 1.8, [](double) { return Eigen::Vector2d(22.0, -5.0); });
  EXPECT_EQ(moverRemoved(4.2, 1.8), 0.0);
  EXPECT_EQ(parkedRemoved(), 0.0);
  for (const FrameResult& frame : frames_) {
    for (const PointLabel& label : frame.labels) {
      ASSERT_NE(label.state, PointState::kDynamic) << "scan " << frame.index;
    }
  }
}

TEST_F(VisibilityFilterTest, WhatIsHiddenByANewOccluderIsNeverDynamic) {
  // A lorry comes to stand before the parked car, and hides it for the rest of the drive.
  drive(20, 7.0, 1.0,
        [](double k) { return k < 8.0 ? Eigen::Vector2d(60.0, 2.5) : Eigen::Vector2d(14.0, 2.5); });
  EXPECT_EQ(parkedRemoved(), 0.0);
}

TEST_F(VisibilityFilterTest, ACarThatLeavesItsPlaceIsRemovedFromThere) {
  drive(24, 4.2, 1.8,
        [](double k) { return Eigen::Vector2d(20.0 + (k < 12.0 ? 0.0 : 1.2 * (k - 12.0)), -3.0); });
  EXPECT_GT(moverRemoved(4.2, 1.8), 0.8) << "semi-static: it drove, so it does not belong there";
}

/// A car that drives ahead for 2 s, then stands for 3 s: longer than the window holds.
Eigen::Vector2d stopsAtLights(double k) { return {16.0 + (k < 20.0 ? 1.0 * k : 20.0), -3.0}; }

TEST_F(VisibilityFilterTest, ACarThatStopsAtLightsGoesWithItsTrack) {
  config_.df.window = 16;
  drive(50, 4.2, 1.8, stopsAtLights);
  EXPECT_GT(moverRemoved(4.2, 1.8), kNearlyAll);
  EXPECT_EQ(parkedRemoved(), 0.0);
}

TEST_F(VisibilityFilterTest, WhereTheUserWantsItItStaysWhileItStands) {
  config_.df.window = 16;
  config_.df.semi_static = SemiStatic::kKeepWhileParked;
  drive(50, 4.2, 1.8, stopsAtLights);
  double kept = 0.0;
  double points = 0.0;
  for (const FrameResult& frame : frames_) {
    if (frame.index < 30) continue;  // a second after it has stopped
    for (std::size_t i = 0; i < frame.labels.size(); ++i) {
      const Eigen::Vector3d x = frame.scan.pose * frame.scan.points[i].position().cast<double>();
      if (x.z() < 0.05 || std::abs(x.x() - 36.0) > 2.1 || std::abs(x.y() + 3.0) > 0.9) continue;
      points += 1.0;
      kept += isKept(frame.labels[i].state) ? 1.0 : 0.0;
    }
  }
  EXPECT_GT(points, 0.0);
  EXPECT_EQ(kept, points);
}

TEST_F(VisibilityFilterTest, NoPointIsLostAndNoneIsCountedTwice) {
  drive(12, 4.2, 1.8, [](double k) { return Eigen::Vector2d(30.0 - k, -3.0); });
  ASSERT_EQ(frames_.size(), 12U);
  for (const FrameResult& frame : frames_) {
    ASSERT_EQ(frame.labels.size(), frame.scan.points.size());
    for (const PointLabel& label : frame.labels) EXPECT_NE(label.state, PointState::kUnjudged);
    std::size_t labelled = 0;
    std::size_t listed = 0;
    for (const PointLabel& label : frame.labels) labelled += label.instance != 0 ? 1 : 0;
    for (const InstanceObservation& seen : frame.instances) listed += seen.points;
    EXPECT_EQ(labelled, listed);
  }
}

}  // namespace
}  // namespace segdf

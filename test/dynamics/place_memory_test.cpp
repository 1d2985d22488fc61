// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/place_memory.hpp"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/pipeline/pipeline.hpp"

#include "support/box_world.hpp"
#include "support/flushed.hpp"

namespace segdf {
namespace {

constexpr std::int64_t kTenth = 100000000;  // nanoseconds
constexpr std::size_t kLeaves = 45;         // scan before which the car drives off
constexpr std::size_t kScans = 80;
const Eigen::Vector2d kPlace(14.0, 5.0);

/// Who waits in a street, with a window of 3.2 s, and sees a car that stands for 4.5 s and is gone
/// then.
class PlaceMemoryTest : public ::testing::Test {
 protected:
  PlaceMemoryTest() {
    // What stands was found again by three frames that are far enough in time: 1, 2 and 3 s later.
    config_.df.window = 32;
    street_ = test::makeStreet();
    car_ = street_.add(kPlace.x(), kPlace.y(), 4.2, 1.8, 1.5);
    for (double x : {-12.0, 7.0, 21.0, 28.0})
      others_.push_back(street_.add(x, -5.0, 4.2, 1.8, 1.5));
  }

  void drive() {
    Pipeline pipeline(config_, 1);
    for (std::size_t k = 0; k < kScans; ++k) {
      if (k == kLeaves) street_.moveTo(car_, 300.0, 0.0);
      const auto stamp = static_cast<std::int64_t>(k + 1) * kTenth;
      collect(pipeline.process(street_.scan(0.0, 0.0, 0.0, stamp, 600)));
    }
    collect(test::flushed(pipeline));
  }

  void collect(std::vector<FrameResult> results) {
    for (FrameResult& result : results) {
      for (const Revocation& revocation : result.revoked) {
        EXPECT_LT(revocation.last, frames_.size()) << "only frames that have come out are revoked";
        revocations_.push_back(revocation);
      }
      frames_.push_back(std::move(result));
    }
  }

  bool isRevoked(std::uint32_t id, std::size_t scan) const {
    for (const Revocation& r : revocations_) {
      if (r.id == id && scan >= r.first && scan <= r.last) return true;
    }
    return false;
  }

  /// Share of the car's points above 0.4 m that were removed at once, or revoked.
  double carRemoved() const {
    double points = 0.0;
    double removed = 0.0;
    for (const FrameResult& frame : frames_) {
      if (frame.index >= kLeaves) break;
      for (std::size_t i = 0; i < frame.labels.size(); ++i) {
        const Eigen::Vector3d x = frame.scan.pose * frame.scan.points[i].position().cast<double>();
        if (x.z() < 0.4 || (x.head<2>() - kPlace).cwiseAbs().maxCoeff() > 2.2) continue;
        points += 1.0;
        const bool dynamic = frame.labels[i].state == PointState::kDynamic;
        removed += dynamic || isRevoked(frame.labels[i].instance, frame.index) ? 1.0 : 0.0;
      }
    }
    return removed / points;
  }

  Config config_;
  test::BoxWorld street_;
  std::size_t car_ = 0;
  std::vector<std::size_t> others_;
  std::vector<FrameResult> frames_;
  std::vector<Revocation> revocations_;
};

TEST_F(PlaceMemoryTest, WhatLeftAfterTheWindowIsRevokedWhereverItStood) {
  drive();
  ASSERT_FALSE(revocations_.empty());
  // The scene has no noise: what is missing are the frames that were the last to be decided.
  EXPECT_GT(carRemoved(), 0.95);
  for (const Revocation& r : revocations_) {
    EXPECT_LT((r.center.head<2>() - kPlace).norm(), 1.0) << "nothing else has left";
  }
}

TEST_F(PlaceMemoryTest, ARevocationCountsThePointsThatWereKept) {
  drive();
  ASSERT_FALSE(revocations_.empty());
  for (const Revocation& r : revocations_) {
    std::size_t points = 0;
    std::size_t frames = 0;
    for (std::size_t scan = r.first; scan <= r.last; ++scan) {
      std::size_t here = 0;
      for (const PointLabel& label : frames_[scan].labels) here += label.instance == r.id ? 1 : 0;
      points += here;
      frames += here > 0 ? 1 : 0;
    }
    EXPECT_EQ(points, r.points);
    EXPECT_EQ(frames, r.frames);
  }
}

TEST_F(PlaceMemoryTest, WithoutItMostOfTheCarStays) {
  config_.df.left_looks = 0;
  drive();
  EXPECT_TRUE(revocations_.empty());
  EXPECT_LT(carRemoved(), 0.6);
}

TEST_F(PlaceMemoryTest, WhatIsKeptWhileParkedIsNotRevoked) {
  config_.df.semi_static = SemiStatic::kKeepWhileParked;
  drive();
  EXPECT_TRUE(revocations_.empty());
}

TEST_F(PlaceMemoryTest, WhereNothingIsFoundAgainThePosesAreToBlame) {
  // All five cars seem to have gone at once.
  Pipeline pipeline(config_, 1);
  for (std::size_t k = 0; k < kScans; ++k) {
    if (k == kLeaves) {
      street_.moveTo(car_, 300.0, 0.0);
      for (std::size_t other : others_) street_.moveTo(other, 300.0, 0.0);
    }
    const auto stamp = static_cast<std::int64_t>(k + 1) * kTenth;
    collect(pipeline.process(street_.scan(0.0, 0.0, 0.0, stamp, 600)));
  }
  collect(test::flushed(pipeline));
  EXPECT_TRUE(revocations_.empty());
}

}  // namespace
}  // namespace segdf

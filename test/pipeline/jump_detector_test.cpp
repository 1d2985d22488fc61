// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/jump_detector.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr double kMaxJump = 1.0;  // metres

Scan scanAt(double seconds, double x) {
  Scan scan;
  scan.stamp_ns = static_cast<std::int64_t>(seconds * 1e9);
  scan.pose.translation().x() = x;
  return scan;
}

/// Which of the scans at these places, 0.1 s apart, lie behind a jump.
std::vector<int> jumpsAlong(const std::vector<double>& places, double max_jump = kMaxJump) {
  JumpDetector detector(max_jump);
  std::vector<int> found;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (detector.jumps(scanAt(1.0 + 0.1 * static_cast<double>(k), places[k]))) {
      found.push_back(static_cast<int>(k));
    }
  }
  return found;
}

TEST(JumpDetector, SpeedIsNoJump) {
  EXPECT_TRUE(jumpsAlong({0.0, 4.0, 8.0, 12.0, 16.0}).empty()) << "40 m/s";
}

TEST(JumpDetector, BrakingIsNoJump) {
  // From 20 m/s at 9 m/s^2.
  EXPECT_TRUE(jumpsAlong({0.0, 2.0, 3.955, 5.82, 7.595, 9.28}).empty());
}

TEST(JumpDetector, CorrectionOfALoopClosureIsFoundOnce) {
  EXPECT_EQ(jumpsAlong({0.0, 1.0, 2.0, 4.5, 5.5, 6.5, 7.5}), std::vector<int>{3});
}

TEST(JumpDetector, EverySecondCorrectionIsFoundToo) {
  EXPECT_EQ(jumpsAlong({0.0, 1.0, 2.0, 4.5, 5.5, 6.5, 3.0, 4.0}), (std::vector<int>{3, 6}));
}

TEST(JumpDetector, AfterAGapInTimeMuchIsExplained) {
  JumpDetector detector(kMaxJump);
  detector.jumps(scanAt(1.0, 0.0));
  detector.jumps(scanAt(1.1, 1.0));
  // In 2 s a car at 10 m/s may have stopped: 20 m less than expected.
  EXPECT_FALSE(detector.jumps(scanAt(3.1, 1.0)));
}

TEST(JumpDetector, WhatIsNoPoseIsPassedOver) {
  JumpDetector detector(kMaxJump);
  detector.jumps(scanAt(1.0, 0.0));
  detector.jumps(scanAt(1.1, 1.0));
  EXPECT_FALSE(detector.jumps(scanAt(1.2, std::nan(""))));
  EXPECT_FALSE(detector.jumps(scanAt(1.1, 50.0))) << "no later stamp";
  EXPECT_FALSE(detector.jumps(scanAt(1.2, 2.0)));
  EXPECT_TRUE(detector.jumps(scanAt(1.3, 5.0)));
}

TEST(JumpDetector, ZeroTurnsItOff) { EXPECT_TRUE(jumpsAlong({0.0, 1.0, 100.0}, 0.0).empty()); }

}  // namespace
}  // namespace segdf

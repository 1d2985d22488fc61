// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/scan_gate.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

Scan scanAt(double x, std::int64_t stamp_ns) {
  Scan scan;
  scan.stamp_ns = stamp_ns;
  scan.pose.translation().x() = x;
  scan.points.push_back({5.0F, 0.0F, 0.0F, 0.1F, 0.0F, -1});
  return scan;
}

TEST(ScanGate, TurnsAwayWhatCannotBeUsed) {
  ScanGate gate{InputConfig{}};
  EXPECT_EQ(gate.admit(scanAt(0.0, 10)), FrameStatus::kMapped);
  EXPECT_EQ(gate.admit(scanAt(0.0, 10)), FrameStatus::kTimeBackwards);
  EXPECT_EQ(gate.admit(scanAt(0.0, 9)), FrameStatus::kTimeBackwards);
  EXPECT_EQ(gate.admit(scanAt(std::nan(""), 11)), FrameStatus::kInvalidPose);
  Scan empty = scanAt(0.0, 12);
  empty.points.clear();
  EXPECT_EQ(gate.admit(empty), FrameStatus::kEmpty);
  Scan near = scanAt(0.0, 12);
  near.points[0].x = 0.5F;  // all on the own vehicle
  EXPECT_EQ(gate.admit(near), FrameStatus::kEmpty);
  EXPECT_EQ(gate.admit(scanAt(0.0, 12)), FrameStatus::kMapped)
      << "what was turned away left no trace";
}

TEST(ScanGate, KeyFramesByWayOrTurn) {
  InputConfig config;
  config.keyframe_distance = 2.0;
  config.keyframe_angle = 20.0;
  ScanGate gate(config);
  EXPECT_EQ(gate.admit(scanAt(0.0, 1)), FrameStatus::kMapped);
  EXPECT_EQ(gate.admit(scanAt(1.9, 2)), FrameStatus::kNotKeyFrame);
  EXPECT_EQ(gate.admit(scanAt(2.1, 3)), FrameStatus::kMapped);
  Scan turned = scanAt(2.2, 4);
  turned.pose.rotate(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()));  // 23 degrees
  EXPECT_EQ(gate.admit(turned), FrameStatus::kMapped);
}

TEST(ScanGate, WhoStandsStillLooksOnNowAndThen) {
  constexpr std::int64_t kSecond = 1000000000;
  InputConfig config;
  config.keyframe_distance = 2.0;
  config.keyframe_time = 1.0;
  ScanGate gate(config);
  EXPECT_EQ(gate.admit(scanAt(0.0, kSecond)), FrameStatus::kMapped);
  EXPECT_EQ(gate.admit(scanAt(0.0, 2 * kSecond - 1000)), FrameStatus::kNotKeyFrame);
  EXPECT_EQ(gate.admit(scanAt(0.0, 2 * kSecond + 1000)), FrameStatus::kMapped);
  EXPECT_EQ(gate.admit(scanAt(0.0, 3 * kSecond)), FrameStatus::kNotKeyFrame);
  config.keyframe_time = 0.0;
  gate = ScanGate(config);
  EXPECT_EQ(gate.admit(scanAt(0.0, kSecond)), FrameStatus::kMapped);
  EXPECT_EQ(gate.admit(scanAt(0.0, 100 * kSecond)), FrameStatus::kNotKeyFrame);
}

TEST(ScanGate, ADistanceOfZeroMakesEveryScanAKeyFrame) {
  ScanGate gate{InputConfig{}};
  for (std::int64_t k = 1; k < 5; ++k) EXPECT_EQ(gate.admit(scanAt(0.0, k)), FrameStatus::kMapped);
}

}  // namespace
}  // namespace segdf

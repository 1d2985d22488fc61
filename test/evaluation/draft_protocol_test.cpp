// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/draft_protocol.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr std::uint32_t kKept = 9;
constexpr std::uint32_t kRemoved = 251;

/// Static points every 1 m from x = 10 on, and one moving point 0.08 m above the first.
Scan exampleScan() {
  Scan scan;
  for (int k = 0; k < 5; ++k) {
    scan.points.push_back({10.0F + static_cast<float>(k), 0.0F, 0.0F, 0.0F, 0.0F, -1});
  }
  scan.points.push_back({10.0F, 0.0F, 0.08F, 0.0F, 0.0F, -1});  // moving, beside static
  scan.points.push_back({20.0F, 0.0F, 0.0F, 0.0F, 0.0F, -1});   // moving
  scan.points.push_back({21.0F, 0.0F, 0.0F, 0.0F, 0.0F, -1});   // moving
  scan.points.push_back({0.0F, 51.0F, 0.0F, 0.0F, 0.0F, -1});   // out of range
  scan.points.push_back({0.0F, 20.0F, 0.0F, 0.0F, 0.0F, -1});   // unlabelled
  return scan;
}

const std::vector<std::uint32_t> kTruth{50, 50, 50, 50, 50, 252, 254, 254, 50, 0};

TEST(Draft, HandComputedExampleByLabels) {
  DraftProtocol protocol;
  // Kept: three static points, both lower moving ones wrongly; lost: two static points.
  protocol.add(exampleScan(), kTruth,
               {kKept, kKept, kKept, kRemoved, 0, kKept, kKept, kRemoved, kKept, kKept});
  const DraftScores scores = protocol.score();
  EXPECT_EQ(scores.true_positive, 4U) << "the moving point 8 cm above a static one counts as TP";
  EXPECT_EQ(scores.false_positive, 1U);
  EXPECT_EQ(scores.false_negative, 2U);
  EXPECT_EQ(scores.rejected_dynamic.whole, 3U);
  EXPECT_EQ(scores.rejected_dynamic.part, 1U);
  EXPECT_DOUBLE_EQ(*scores.precision(), 80.0);
  EXPECT_DOUBLE_EQ(*scores.recall(), 100.0 * 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(*scores.f1(), 8.0 / 11.0);
  EXPECT_EQ(scores.points.size(), 7U) << "TP, FP and FN make the coloured map";
  EXPECT_EQ(std::count(scores.verdicts.begin(), scores.verdicts.end(), MapVerdict::kFalseNegative),
            2);
}

TEST(Draft, AMapOfTheSamePointsScoresTheSame) {
  DraftProtocol protocol;
  protocol.add(exampleScan(), kTruth, {});
  // The kept points of the example above, those out of range and unlabelled among them.
  const DraftScores scores = protocol.score({{10.0F, 0.0F, 0.0F},
                                             {11.0F, 0.0F, 0.0F},
                                             {12.0F, 0.0F, 0.0F},
                                             {10.0F, 0.0F, 0.08F},
                                             {20.0F, 0.0F, 0.0F},
                                             {0.0F, 51.0F, 0.0F},
                                             {0.0F, 20.0F, 0.0F}});
  EXPECT_EQ(scores.true_positive, 4U);
  EXPECT_EQ(scores.false_positive, 1U);
  EXPECT_EQ(scores.false_negative, 2U);
  EXPECT_EQ(scores.rejected_dynamic.part, 1U);
}

TEST(Draft, MapsAreComparedOnVoxels) {
  DraftProtocol protocol;
  Scan scan;
  for (int k = 0; k < 4; ++k) {  // two in one voxel of 5 cm, two in another
    scan.points.push_back({10.01F + 0.02F * static_cast<float>(k), 0.01F, 0.01F, 0.0F, 0.0F, -1});
  }
  protocol.add(scan, {50, 50, 50, 50}, {kKept, kKept, kKept, kKept});
  EXPECT_EQ(protocol.score().true_positive, 2U);
}

TEST(Draft, WithoutAnyPointThereIsNoFigure) {
  const DraftScores scores = DraftProtocol().score();
  EXPECT_FALSE(scores.precision());
  EXPECT_FALSE(scores.recall());
  EXPECT_FALSE(scores.f1());
}

TEST(Draft, ListsOfDifferentLengthAreRefused) {
  DraftProtocol protocol;
  EXPECT_THROW(protocol.add(exampleScan(), {1}, {}), std::invalid_argument);
  EXPECT_THROW(protocol.add(exampleScan(), kTruth, {1}), std::invalid_argument);
}

TEST(SpacedScans, EveryTwoMetresFromTheLastOnePicked) {
  SpacedScans spaced(2.0);
  std::vector<bool> picked;
  for (const double x : {0.0, 1.2, 2.4, 3.6, 4.4, 4.5}) {
    Pose pose = Pose::Identity();
    pose.translation().x() = x;
    picked.push_back(spaced.pick(pose));
  }
  EXPECT_EQ(picked, (std::vector<bool>{true, false, true, false, true, false}));
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/baselines.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"

namespace segdf {
namespace {

/// Key frames without points at given times and ways.
class Baselines : public ::testing::Test {
 protected:
  void add(double time, double way) {
    auto frame = std::make_unique<KeyFrame>();
    frame->scan.stamp_ns = static_cast<std::int64_t>(time * 1e9);
    frame->evidence = std::make_shared<FrameEvidence>(prepareEvidence(*frame, config_));
    frame->evidence->way = way;
    window_.push_back(frame.get());
    frames_.push_back(std::move(frame));
  }

  DynamicConfig config_;
  std::vector<std::unique_ptr<KeyFrame>> frames_;
  Window window_;
};

TEST_F(Baselines, AtTenScansASecondEachTimeHasItsFrame) {
  for (int k = 0; k <= 60; ++k) add(0.1 * k, 0.0);
  // 5, 3, 2, 1, 0.6, 0.3 and 0.1 s before the newest, which is 60; 5 % short is enough.
  EXPECT_EQ(selectBaselines(window_, config_),
            (std::vector<std::size_t>{12, 31, 40, 50, 54, 57, 59}));
}

TEST_F(Baselines, AtTwoScansASecondTheShortTimesShareOne) {
  for (int k = 0; k <= 12; ++k) add(0.5 * k, 0.0);
  EXPECT_EQ(selectBaselines(window_, config_), (std::vector<std::size_t>{2, 6, 8, 10, 11}));
}

TEST_F(Baselines, WaysCountWhereTheEgoMoves) {
  for (int k = 0; k <= 20; ++k) add(10.0 * k, 2.0 * k);  // slow: times say nothing but "the last"
  EXPECT_EQ(selectBaselines(window_, config_),
            (std::vector<std::size_t>{4, 8, 12, 15, 17, 18, 19}));
}

TEST_F(Baselines, ASingleFrameHasNone) {
  add(0.0, 0.0);
  EXPECT_TRUE(selectBaselines(window_, config_).empty());
}

TEST_F(Baselines, AFrameIsOutOfReachOfTimeAndWay) {
  add(0.0, 0.0);
  add(6.0, 10.0);
  EXPECT_FALSE(isOutOfReach(window_, config_)) << "32 m are still to come";
  add(7.0, 35.0);
  EXPECT_TRUE(isOutOfReach(window_, config_));
}

TEST_F(Baselines, AFullWindowLetsTheOldestGo) {
  config_.window = 4;
  for (int k = 0; k < 4; ++k) add(0.1 * k, 0.0);
  EXPECT_FALSE(isOutOfReach(window_, config_));
  add(0.4, 0.0);
  EXPECT_TRUE(isOutOfReach(window_, config_));
}

}  // namespace
}  // namespace segdf

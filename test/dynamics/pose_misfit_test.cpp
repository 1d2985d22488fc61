// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/pose_misfit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

class PoseMisfit : public ::testing::Test {
 protected:
  /// Misfit of two scans of the street 1 m apart when the second pose is wrong by (dx, dy) metres.
  double misfitWithError(double dx, double dy) {
    Scan second = test::makeStreet().scan(1.0, 0.0, 0.0, 2);
    second.pose.translation() += Eigen::Vector3d(dx, dy, 0.0);
    const auto a = test::makeKeyFrame(test::makeStreet().scan(0.0, 0.0, 0.0, 1), config_);
    const auto b = test::makeKeyFrame(std::move(second), config_);
    return poseMisfit(*b, *a, grid_);
  }

  Config config_;
  CurvedGrid grid_{config_.cvi, config_.input.min_range};
};

TEST_F(PoseMisfit, ExactPosesFit) { EXPECT_LT(misfitWithError(0.0, 0.0), 0.01); }

TEST_F(PoseMisfit, MeasuresTheError) {
  // The street's walls face the error across it, so the median is the error itself.
  EXPECT_NEAR(misfitWithError(0.0, 0.15), 0.15, 0.03);
}

TEST_F(PoseMisfit, PosesThatDoNotBelongToTheScansExceedTheLimit) {
  EXPECT_GT(misfitWithError(0.0, 1.0), config_.input.max_misfit);
}

TEST_F(PoseMisfit, TooLittleToCompareIsNotANumber) {
  const auto empty = test::makeKeyFrame(test::BoxWorld().scan(0.0, 0.0, 0.0, 1), config_);
  EXPECT_TRUE(std::isnan(poseMisfit(*empty, *empty, grid_)));
}

}  // namespace
}  // namespace segdf

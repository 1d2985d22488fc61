// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/scan.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(Pose, ARotationWithTranslationIsValid) {
  Pose pose = Pose::Identity();
  pose.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()));
  pose.translation() = Eigen::Vector3d(1e5, -2.0, 3.0);
  EXPECT_TRUE(isValidPose(pose));
}

TEST(Pose, NaNScalingAndMirroringAreNot) {
  Pose nan = Pose::Identity();
  nan.translation().x() = std::nan("");
  EXPECT_FALSE(isValidPose(nan));
  Pose scaled = Pose::Identity();
  scaled.linear() *= 1.01;
  EXPECT_FALSE(isValidPose(scaled));
  Pose mirrored = Pose::Identity();
  mirrored.linear()(0, 0) = -1.0;
  EXPECT_FALSE(isValidPose(mirrored));
  Pose zero = Pose::Identity();
  zero.linear().setZero();
  EXPECT_FALSE(isValidPose(zero));
}

TEST(Point, FiniteMeansAllThreeCoordinates) {
  Point p;
  EXPECT_TRUE(isFinite(p));
  p.z = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(isFinite(p));
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/footprint.hpp"

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(Footprint, ASquareWithAMargin) {
  const Footprint square({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 0}});
  EXPECT_TRUE(square.contains({1.0F, 1.0F}, 0.5F));
  EXPECT_TRUE(square.contains({2.4F, 1.0F}, 0.5F)) << "within the margin";
  EXPECT_FALSE(square.contains({2.6F, 1.0F}, 0.5F));
  EXPECT_TRUE(square.contains({2.3F, 2.3F}, 0.5F)) << "0.42 m from the corner";
  EXPECT_FALSE(square.contains({2.4F, 2.4F}, 0.5F)) << "0.57 m from the corner";
}

TEST(Footprint, PointsWithoutAnArea) {
  const Footprint one({{1, 1}});
  EXPECT_TRUE(one.contains({1.1F, 1.1F}, 0.2F));
  EXPECT_FALSE(one.contains({1.3F, 1.0F}, 0.2F));
  const Footprint line({{0, 0}, {1, 0}, {2, 0}});
  EXPECT_TRUE(line.contains({1.5F, -0.1F}, 0.2F));
  EXPECT_FALSE(line.contains({1.5F, 0.3F}, 0.2F));
  const Footprint same({{1, 1}, {1, 1}, {1, 1}});
  EXPECT_TRUE(same.contains({1.0F, 1.1F}, 0.2F));
}

TEST(Volume, ReachesFromItsBottomToItsTop) {
  const Volume volume{Footprint({{0.0F, 0.0F}, {4.0F, 0.0F}, {4.0F, 2.0F}, {0.0F, 2.0F}}), 0.5F,
                      1.5F};
  EXPECT_TRUE(volume.contains({2.0F, 1.0F, 1.0F}, 0.0F));
  EXPECT_TRUE(volume.contains({2.0F, 1.0F, 1.7F}, 0.3F));
  EXPECT_FALSE(volume.contains({2.0F, 1.0F, 1.9F}, 0.3F));
  EXPECT_FALSE(volume.contains({2.0F, 1.0F, 0.1F}, 0.3F));
  EXPECT_TRUE(volume.contains({4.2F, 1.0F, 1.0F}, 0.3F));
  EXPECT_FALSE(volume.contains({4.4F, 1.0F, 1.0F}, 0.3F));
}

TEST(Volume, IsTakenIntoAnotherFrame) {
  const Volume volume{Footprint({{0.0F, 0.0F}, {4.0F, 0.0F}, {4.0F, 2.0F}, {0.0F, 2.0F}}), 0.5F,
                      1.5F};
  const Eigen::Isometry3f turned_left =
      Eigen::Translation3f(10.0F, 0.0F, -1.0F) *
      Eigen::AngleAxisf(0.5F * static_cast<float>(M_PI), Eigen::Vector3f::UnitZ());
  const Volume there = transformed(volume, turned_left);
  EXPECT_TRUE(there.contains({9.0F, 3.5F, 0.4F}, 0.0F));
  EXPECT_FALSE(there.contains({9.0F, 3.5F, 0.6F}, 0.0F));
  EXPECT_FALSE(there.contains({7.5F, 3.5F, 0.4F}, 0.0F));
  EXPECT_FALSE(there.contains({9.0F, 4.5F, 0.4F}, 0.0F));
}

}  // namespace
}  // namespace segdf

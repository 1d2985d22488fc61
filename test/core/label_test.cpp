// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/label.hpp"

#include <gtest/gtest.h>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {
namespace {

using semantic_kitti::classOf;
using semantic_kitti::encode;
using semantic_kitti::instanceOf;

TEST(Label, EveryStateHasItsCode) {
  EXPECT_EQ(encode({0, PointState::kUnjudged, ObjectClass::kNone}), 0U);
  EXPECT_EQ(encode({0, PointState::kGround, ObjectClass::kNone}), 40U);
  EXPECT_EQ(encode({0, PointState::kNoise, ObjectClass::kNone}), 9U);
  EXPECT_EQ(classOf(encode({7, PointState::kStatic, ObjectClass::kUnknown})), 9U);
  EXPECT_EQ(classOf(encode({7, PointState::kStatic, ObjectClass::kHighMobility})), 10U);
  EXPECT_EQ(classOf(encode({7, PointState::kStatic, ObjectClass::kBuilding})), 50U);
  EXPECT_EQ(classOf(encode({7, PointState::kStatic, ObjectClass::kVegetation})), 70U);
  EXPECT_EQ(classOf(encode({7, PointState::kDynamic, ObjectClass::kVegetation})), 251U);
}

TEST(Label, InstanceIsInTheUpperHalf) {
  EXPECT_EQ(instanceOf(encode({65535, PointState::kStatic, ObjectClass::kUnknown})), 65535U);
}

TEST(Label, InstancesThatDoNotFitBeginAnew) {
  EXPECT_EQ(instanceOf(encode({65536, PointState::kStatic, ObjectClass::kUnknown})), 1U);
  EXPECT_EQ(instanceOf(encode({65535 + 7, PointState::kDynamic, ObjectClass::kUnknown})), 7U);
  EXPECT_EQ(classOf(encode({65535 + 7, PointState::kDynamic, ObjectClass::kUnknown})), 251U);
  EXPECT_EQ(semantic_kitti::shortId(2 * 65535), 65535U);
  EXPECT_EQ(semantic_kitti::shortId(0), 0U);
}

TEST(Label, ParkedMovablesAreTheTenStandingClasses) {
  int count = 0;
  for (std::uint16_t c = 0; c < 300; ++c) count += semantic_kitti::isParkedMovable(c) ? 1 : 0;
  EXPECT_EQ(count, 10);
  EXPECT_TRUE(semantic_kitti::isParkedMovable(10));
  EXPECT_FALSE(semantic_kitti::isParkedMovable(252));
}

TEST(Label, OnlyGroundStaticAndNoiseAreKept) {
  EXPECT_TRUE(isKept(PointState::kGround));
  EXPECT_TRUE(isKept(PointState::kStatic));
  EXPECT_TRUE(isKept(PointState::kNoise));
  EXPECT_FALSE(isKept(PointState::kDynamic));
  EXPECT_FALSE(isKept(PointState::kUnjudged));
}

}  // namespace
}  // namespace segdf

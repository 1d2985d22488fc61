// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/classifier.hpp"

#include <gtest/gtest.h>

namespace segdf {
namespace {

/// A smooth solid object standing on the ground.
FeatureVector object(float length, float width, float top) {
  FeatureVector f;
  f[Feature::kLength] = length;
  f[Feature::kWidth] = width;
  f[Feature::kTop] = top;
  f[Feature::kSmoothShare] = 0.6F;
  f[Feature::kLocalCurvature] = 0.01F;
  f[Feature::kVerticalShare] = 0.5F;
  f[Feature::kCurvatureChange] = 0.1F;
  f[Feature::kEigenvalueSum] = 1.0F;
  f[Feature::kRange] = 20.0F;
  return f;
}

FeatureVector leafy(FeatureVector f) {
  f[Feature::kSmoothShare] = 0.03F;
  f[Feature::kLocalCurvature] = 0.12F;
  f[Feature::kVerticalShare] = 0.4F;
  return f;
}

FeatureVector flatWall(FeatureVector f) {
  f[Feature::kVerticalShare] = 0.95F;
  f[Feature::kCurvatureChange] = 0.001F;
  return f;
}

ObjectClass classOf(const FeatureVector& f) { return classify(f, 200, ClassConfig{}); }

TEST(Classifier, CarsAndPeopleAreHighMobility) {
  EXPECT_EQ(classOf(object(4.3F, 1.8F, 1.5F)), ObjectClass::kHighMobility);
  EXPECT_EQ(classOf(object(1.6F, 0.3F, 1.4F)), ObjectClass::kHighMobility) << "rear face";
  EXPECT_EQ(classOf(object(0.6F, 0.5F, 1.7F)), ObjectClass::kHighMobility);
  EXPECT_EQ(classOf(object(1.8F, 0.6F, 1.8F)), ObjectClass::kHighMobility) << "cyclist";
  EXPECT_EQ(classOf(leafy(object(0.6F, 0.5F, 1.7F))), ObjectClass::kHighMobility)
      << "clothes are rough, a person is no bush";
}

TEST(Classifier, BigVehiclesAreNeverExcluded) {
  EXPECT_TRUE(isTested(classOf(object(12.0F, 2.55F, 3.2F)))) << "bus";
  EXPECT_TRUE(isTested(classOf(object(8.0F, 2.5F, 2.5F)))) << "truck";
  EXPECT_TRUE(isTested(classOf(object(5.9F, 2.1F, 2.4F)))) << "van";
}

TEST(Classifier, RoughMoversAreNoFoliage) {
  EXPECT_EQ(classOf(leafy(object(1.8F, 0.6F, 1.6F))), ObjectClass::kHighMobility) << "cyclist";
  // From 25 m on, the window of a normal spans the parts of a car's shape.
  FeatureVector far_car = leafy(object(3.6F, 1.6F, 1.4F));
  far_car[Feature::kVerticalShare] = 0.7F;
  EXPECT_EQ(classOf(far_car), ObjectClass::kHighMobility);
  FeatureVector tractor = leafy(object(3.2F, 2.6F, 2.7F));
  tractor[Feature::kVerticalShare] = 0.65F;
  EXPECT_TRUE(isTested(classOf(tractor)));
  FeatureVector van = leafy(object(3.7F, 2.2F, 2.7F));  // 24 m away, its roof seen aslant
  EXPECT_EQ(classOf(van), ObjectClass::kVegetation);
  van[Feature::kSmoothShare] = 0.16F;
  EXPECT_TRUE(isTested(classOf(van)));
}

TEST(Classifier, ABusInTheNextLaneIsNoWall) {
  FeatureVector bus = flatWall(object(9.0F, 1.6F, 1.85F));  // roof and wheels cut off
  bus[Feature::kGroundContact] = 0.2F;
  EXPECT_EQ(classOf(bus), ObjectClass::kBuilding);
  bus[Feature::kRange] = 3.5F;
  EXPECT_TRUE(isTested(classOf(bus)));
  bus[Feature::kTop] = 2.5F;
  EXPECT_TRUE(isTested(classOf(bus)));
  bus[Feature::kLength] = 16.0F;
  EXPECT_EQ(classOf(bus), ObjectClass::kBuilding) << "longer than a bus";
}

TEST(Classifier, TheTailOfACarIsNoFence) {
  EXPECT_TRUE(isTested(classOf(flatWall(object(1.85F, 0.17F, 0.9F)))));
  EXPECT_EQ(classOf(flatWall(object(2.6F, 0.17F, 0.9F))), ObjectClass::kBuilding);
}

TEST(Classifier, TwoCarsSideBySideAreNoHedge) {
  FeatureVector pair = leafy(object(4.4F, 3.3F, 1.5F));
  pair[Feature::kVerticalShare] = 0.72F;
  EXPECT_TRUE(isTested(classOf(pair)));
}

TEST(Classifier, WhatIsHigherOrWiderThanATruckIsNone) {
  EXPECT_TRUE(isTested(classOf(object(9.0F, 2.5F, 4.2F)))) << "truck of the greatest legal height";
  EXPECT_EQ(classOf(object(9.0F, 2.5F, 5.0F)), ObjectClass::kBuilding);
  EXPECT_EQ(classOf(leafy(object(2.5F, 2.5F, 5.0F))), ObjectClass::kVegetation);
  EXPECT_EQ(classOf(object(9.0F, 3.2F, 3.5F)), ObjectClass::kBuilding);
}

TEST(Classifier, AFrontStandsOnTheGroundAndABusOnItsWheels) {
  FeatureVector front = object(9.0F, 0.6F, 3.0F);
  front[Feature::kVerticalShare] = 0.95F;
  front[Feature::kGroundContact] = 0.6F;
  EXPECT_EQ(classOf(front), ObjectClass::kBuilding);
  front[Feature::kGroundContact] = 0.02F;
  EXPECT_TRUE(isTested(classOf(front)));
  FeatureVector bus = object(12.0F, 2.4F, 3.1F);
  bus[Feature::kVerticalShare] = 0.95F;
  bus[Feature::kGroundContact] = 0.5F;  // 32 lasers: the lowest seen of a bus is often its sill
  EXPECT_TRUE(isTested(classOf(bus)));
}

TEST(Classifier, StructuresAreBuildings) {
  EXPECT_EQ(classOf(object(0.4F, 0.3F, 4.0F)), ObjectClass::kBuilding) << "pole";
  EXPECT_EQ(classOf(object(25.0F, 0.6F, 5.0F)), ObjectClass::kBuilding) << "house";
  EXPECT_EQ(classOf(flatWall(object(9.0F, 0.3F, 1.8F))), ObjectClass::kBuilding) << "garden wall";
  FeatureVector sign = object(0.8F, 0.1F, 2.4F);
  sign[Feature::kBottom] = 1.9F;
  EXPECT_EQ(classOf(sign), ObjectClass::kBuilding) << "no ground contact";
}

TEST(Classifier, FoliageIsVegetation) {
  EXPECT_EQ(classOf(leafy(object(6.0F, 5.0F, 6.0F))), ObjectClass::kVegetation) << "tree";
  EXPECT_EQ(classOf(leafy(object(8.0F, 1.2F, 1.5F))), ObjectClass::kVegetation) << "hedge";
  EXPECT_EQ(classOf(leafy(object(1.6F, 1.4F, 1.1F))), ObjectClass::kVegetation) << "bush";
  FeatureVector crown = leafy(object(4.0F, 4.0F, 5.0F));
  crown[Feature::kBottom] = 2.0F;
  EXPECT_EQ(classOf(crown), ObjectClass::kVegetation);
}

// Few lasers give no normals: a bush has the share of smooth points of a car then.
TEST(Classifier, WhatIsRoughAlongTheLinesIsVegetation) {
  const auto rough = [](FeatureVector f) {
    f[Feature::kSmoothShare] = 0.15F;
    f[Feature::kRoughness] = 0.06F;
    return f;
  };
  const FeatureVector bush = rough(object(2.6F, 1.5F, 1.4F));
  EXPECT_EQ(classOf(bush), ObjectClass::kVegetation);
  EXPECT_TRUE(isTested(classify(bush, 40, ClassConfig{}))) << "a far car, of which little is seen";
  EXPECT_TRUE(isTested(classOf(rough(object(1.9F, 0.7F, 1.7F))))) << "cyclist";
  FeatureVector car = bush;
  car[Feature::kSmoothShare] = 0.3F;
  EXPECT_TRUE(isTested(classOf(car))) << "half of it seen through its windows";
  car = bush;
  car[Feature::kRoughness] = 0.03F;
  EXPECT_TRUE(isTested(classOf(car)));
}

TEST(Classifier, ACutObjectIsTall) {
  FeatureVector trunk = object(0.5F, 0.4F, 2.2F);
  EXPECT_NE(classOf(trunk), ObjectClass::kBuilding);
  trunk[Feature::kTopcut] = 0.9F;
  EXPECT_EQ(classOf(trunk), ObjectClass::kBuilding);
}

TEST(Classifier, LowThingsAreUnknown) {
  EXPECT_EQ(classOf(object(1.0F, 0.4F, 0.2F)), ObjectClass::kUnknown);
}

}  // namespace
}  // namespace segdf

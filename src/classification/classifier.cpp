// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/classifier.hpp"

#include <algorithm>
#include <cmath>

namespace segdf {

namespace {

// Physical sizes (method.md 5.4): a person is 0.3-0.9 m wide and up to 2 m high, a cyclist longer;
// cars are 3.6-5.6 m by 1.6-2.3 m and 1.3-2.6 m high, of which often only one face is seen.
constexpr double kPersonWidth = 1.2;
constexpr double kPersonMinHeight = 0.9;
constexpr double kPersonMaxHeight = 2.1;
constexpr double kCyclistLength = 2.3;
constexpr double kCyclistWidth = 1.1;
constexpr double kCarMinLength = 1.0;
constexpr double kCarMaxLength = 5.6;
constexpr double kCarMaxWidth = 2.3;
constexpr double kCarMinHeight = 0.8;
constexpr double kCarMaxHeight = 2.6;
// The greatest single vehicle seen whole; two sides of a bus turned by 3 degrees need some more
// than its 2.55 m.
constexpr double kVehicleLength = 13.0;
constexpr double kVehicleWidth = 2.9;
constexpr std::size_t kLeafyPoints = 30;
constexpr std::size_t kRoughPoints = 60;
constexpr double kShortWall = 2.0;
// A fence is thin, straight, much longer than wide, and longer than the tail of a car is wide.
constexpr double kFenceVertical = 0.9;
constexpr double kFenceWidth = 0.35;
constexpr double kFenceLength = kCarMaxWidth;
constexpr double kFenceRatio = 4.0;
constexpr double kFenceSigma = 0.06;

/// The features under the names that the rules use.
struct Shape {
  double length, width, side, bottom, top, smooth, curvature, vertical, topcut, contact, range;
  double sigma, roughness;

  explicit Shape(const FeatureVector& f)
      : length(static_cast<double>(f[Feature::kLength])),
        width(static_cast<double>(f[Feature::kWidth])),
        side(std::max(length, width)),
        bottom(static_cast<double>(f[Feature::kBottom])),
        top(static_cast<double>(f[Feature::kTop])),
        smooth(static_cast<double>(f[Feature::kSmoothShare])),
        curvature(static_cast<double>(f[Feature::kLocalCurvature])),
        vertical(static_cast<double>(f[Feature::kVerticalShare])),
        topcut(static_cast<double>(f[Feature::kTopcut])),
        contact(static_cast<double>(f[Feature::kGroundContact])),
        range(static_cast<double>(f[Feature::kRange])),
        sigma(std::sqrt(static_cast<double>(f[Feature::kCurvatureChange]) *
                        static_cast<double>(f[Feature::kEigenvalueSum]))),
        roughness(static_cast<double>(f[Feature::kRoughness])) {}
};

bool isLeafy(const Shape& s, const ClassConfig& c) {
  return s.smooth < c.leafy_smooth && s.curvature > c.leafy_curvature;
}

/// As isLeafy, for what has the size of a vehicle: the parts of one look rough from afar, but some
/// of its surfaces are smooth and most stand upright.
bool isLeafyVehicle(const Shape& s, const ClassConfig& c) {
  return isLeafy(s, c) && s.smooth < c.leafy_vehicle && s.vertical < c.leafy_vertical;
}

/// A bush with the size of a car: rougher than anything on wheels.
bool isBush(const Shape& s, const ClassConfig& c) {
  return s.smooth < c.bush_smooth && s.curvature > c.bush_curvature && s.vertical < c.bush_vertical;
}

/// Rougher along the lines of single lasers than vehicles are. People and cyclists are rough as
/// well when few columns hit them, and so is what few points are seen of.
bool isRough(const Shape& s, std::size_t points, const ClassConfig& c) {
  return s.roughness > c.rough && s.smooth < c.rough_smooth && s.length > kCyclistLength &&
         points >= kRoughPoints;
}

bool isTall(const Shape& s, const ClassConfig& c) {
  return (s.topcut > c.topcut && s.top > c.tall_cut) || s.top > c.tall;
}

bool hasVehicleSize(const Shape& s) {
  return s.length <= kVehicleLength && s.width <= kVehicleWidth;
}

/// A bus in the next lane: the field of view cuts its roof and wheels off, and it is a wall.
bool isBeside(const Shape& s, const ClassConfig& c) {
  return s.range < c.beside && hasVehicleSize(s);
}

bool isWall(const Shape& s, const ClassConfig& c) {
  return s.vertical > c.wall_vertical && (s.width < c.wall_thickness || s.sigma < c.wall_sigma) &&
         !isBeside(s, c);
}

/// A front of a house stands on the ground all along, a bus or truck on its wheels; and it is
/// longer than they are, or seen as thin as they hardly ever are.
bool isFront(const Shape& s, const ClassConfig& c) {
  const bool thin = s.width < c.front_width && s.length > c.front_ratio * s.width;
  return s.vertical > c.front_vertical && s.contact > c.front_contact &&
         (thin || s.length > kVehicleLength) && !isBeside(s, c);
}

bool isPerson(const Shape& s) {
  const bool upright = s.top > kPersonMinHeight && s.top < kPersonMaxHeight;
  return upright && s.side < kPersonWidth;
}

bool isCyclist(const Shape& s) {
  const bool upright = s.top > kPersonMinHeight && s.top < kPersonMaxHeight;
  return upright && s.length <= kCyclistLength && s.width <= kCyclistWidth;
}

bool isCar(const Shape& s) {
  return s.length >= kCarMinLength && s.length <= kCarMaxLength && s.width <= kCarMaxWidth &&
         s.top >= kCarMinHeight && s.top <= kCarMaxHeight;
}

bool isFence(const Shape& s) {
  return s.vertical > kFenceVertical && s.width < kFenceWidth && s.length > kFenceLength &&
         s.length > kFenceRatio * s.width && s.sigma < kFenceSigma;
}

ObjectClass classifyTall(const Shape& s, std::size_t points, const ClassConfig& c) {
  const bool leafy = isLeafy(s, c);
  if (s.side < c.pole_side && s.bottom < c.pole_bottom) return ObjectClass::kBuilding;
  if (s.length > c.large_length || s.width > c.large_width || s.top > c.large_height) {
    return leafy ? ObjectClass::kVegetation : ObjectClass::kBuilding;
  }
  const bool foliage = hasVehicleSize(s) ? isLeafyVehicle(s, c) : leafy;
  if (foliage && points >= kLeafyPoints) return ObjectClass::kVegetation;
  if (isFront(s, c)) return ObjectClass::kBuilding;
  if (isWall(s, c) && s.length < kShortWall && s.bottom < c.pole_bottom)
    return ObjectClass::kBuilding;
  return ObjectClass::kUnknown;  // bus, truck, van and a piece of wall look alike
}

ObjectClass classifyLarge(const Shape& s, const ClassConfig& c) {
  const bool foliage = s.length <= kVehicleLength ? isLeafyVehicle(s, c) : isLeafy(s, c);
  if (foliage) return ObjectClass::kVegetation;
  return isWall(s, c) ? ObjectClass::kBuilding : ObjectClass::kUnknown;
}

ObjectClass classifyByShape(const Shape& s, std::size_t points, const ClassConfig& c) {
  if (s.bottom > c.airborne) {
    return isLeafy(s, c) ? ObjectClass::kVegetation : ObjectClass::kBuilding;
  }
  if (isTall(s, c)) return classifyTall(s, points, c);
  if (s.length > c.long_length || s.width > c.long_width) return classifyLarge(s, c);
  if (s.top < c.low) return ObjectClass::kUnknown;
  const bool on_foot_or_bicycle = isPerson(s) || isCyclist(s);
  if (!on_foot_or_bicycle && isBush(s, c)) return ObjectClass::kVegetation;
  if (isFence(s)) return ObjectClass::kBuilding;
  return on_foot_or_bicycle || isCar(s) ? ObjectClass::kHighMobility : ObjectClass::kUnknown;
}

}  // namespace

ObjectClass classify(const FeatureVector& features, std::size_t points, const ClassConfig& config) {
  const Shape s(features);
  const ObjectClass by_shape = classifyByShape(s, points, config);
  return isTested(by_shape) && isRough(s, points, config) ? ObjectClass::kVegetation : by_shape;
}

}  // namespace segdf

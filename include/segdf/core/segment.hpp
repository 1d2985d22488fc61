// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/label.hpp"

namespace segdf {

/// The geometric feature vector without shape histograms: 17 of the eigenvalue block, 13 of the
/// scale block (draft III-C), and roughness (definitions in classification/features.hpp).
enum class Feature : std::uint8_t {
  kLinearity,
  kPlanarity,
  kScattering,
  kOmnivariance,
  kAnisotropy,
  kEigenentropy,
  kCurvatureChange,
  kEigenvalueSum,
  kVerticality,
  kMainAxisZ,
  kEigenvalueSum2d,
  kEigenvalueRatio2d,
  kMomentFirstAxis,
  kMomentSecondAxis,
  kLocalCurvature,
  kVerticalShare,
  kSmoothShare,
  kBottom,
  kTop,
  kHeight,
  kLength,
  kWidth,
  kElongation,
  kFootprint,
  kVolume,
  kRange,
  kLogCount,
  kDensity,
  kTopcut,
  kGroundContact,
  kRoughness,
  kCount,
};

/// All features of one segment; every entry is finite.
struct FeatureVector {
  std::array<float, static_cast<std::size_t>(Feature::kCount)> values{};

  float& operator[](Feature feature) { return values[static_cast<std::size_t>(feature)]; }
  float operator[](Feature feature) const { return values[static_cast<std::size_t>(feature)]; }
};

/// Upright box around a segment, in the sensor frame.
struct UprightBox {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< metres
  Eigen::Vector3f size = Eigen::Vector3f::Zero();    ///< length >= width, height; metres
  float yaw = 0.0F;                                  ///< of the length axis, rad
};

/// One cluster C of Seg(P_k), formula (3).
struct Segment {
  std::vector<std::uint32_t> points;  ///< indices into the scan, ascending
  Eigen::AlignedBox3f bounds;         ///< sensor frame, metres
  UprightBox box;
  FeatureVector features;
  ObjectClass object_class = ObjectClass::kUnknown;
};

/// What the segmentation says of a point before anything is known of motion.
enum class PointRole : std::uint8_t { kUnused, kGround, kObject };

/// Local surface at a point, from its neighbours in the range image.
struct Surface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit, towards the sensor; zero = not known
  float curvature = -1.0F;                           ///< change of curvature; negative = not known
  float roughness = -1.0F;  ///< from the line between its neighbours, metres; negative = not known

  bool hasNormal() const { return normal.squaredNorm() > 0.5F; }
};

}  // namespace segdf

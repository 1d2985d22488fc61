// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/segment.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf::test {

/// True for SemanticKITTI's classes of things that can move (10-32 without 40 and up, 252-259).
bool isMovable(std::uint16_t semantic_class);

struct Ratio {
  double part = 0.0;
  double whole = 0.0;

  void add(bool hit) {
    part += hit ? 1.0 : 0.0;
    whole += 1.0;
  }
  double percent() const { return whole > 0.0 ? 100.0 * part / whole : 0.0; }
};

/// Ground in Patchwork++'s protocol: road, parking, sidewalk, other ground, lane markings and
/// terrain are ground; vegetation, unlabelled and outliers are not scored.
struct GroundScore {
  Ratio precision;
  Ratio recall;
  Ratio movable;  ///< points of movable instances that are labelled ground
  Ratio moving;   ///< the same for classes 252-259 alone

  void add(const std::vector<PointRole>& roles, const std::vector<std::uint32_t>& truth);
  double f1() const;
};

/// Clusters against the movable instances of at least 30 points (method.md 4.4): for each the
/// cluster of greatest IoU. All points of an instance count, those taken for ground too; points of
/// a cluster that are unlabelled do not.
struct InstanceScore {
  std::size_t instances = 0;
  std::size_t found = 0;  ///< IoU > 0.5
  std::size_t clusters = 0;
  std::size_t scans = 0;
  double iou = 0.0;       ///< sums
  double coverage = 0.0;  ///< share of the instance in its cluster
  double purity = 0.0;    ///< share of the cluster in the instance

  void add(const std::vector<std::int32_t>& of_point,
           const std::vector<PointRole>& roles,
           const std::vector<std::uint32_t>& truth);
};

/// What becomes of the points of each kind of truth.
struct ClassScore {
  enum Truth { kMovable, kBuilding, kVegetation, kPole, kGroundTruth, kOther, kTruths };
  enum Answer { kGround, kNoise, kVeg, kBuild, kHighMobility, kUnknown, kAnswers };

  std::array<std::array<double, kAnswers>, kTruths> points{};

  void add(const Segmentation& seg, const std::vector<std::uint32_t>& truth);
  double total(Truth truth) const;
  /// Percent of the points in segments that the dynamic test does not see.
  double excludedOfSegmented(Truth truth) const;
  /// Percent of all points that the dynamic test does not see: ground, vegetation and building.
  double excludedOfAll(Truth truth) const;
};

}  // namespace segdf::test

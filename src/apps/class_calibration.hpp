// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf::apps {

/// What ground truth says of a segment.
enum class Truth : std::uint8_t { kMovable, kBuilding, kVegetation, kOther };

/// Labelled segments of any number of scans, and thresholds fitted to them (method.md 5.5).
class ClassCalibration {
 public:
  /// Movable points that must stay in the dynamic test, and points of buildings and vegetation that
  /// the classes take out of it; percent.
  struct Score {
    double movable_kept = 100.0;
    double excluded = 0.0;
  };

  /// Takes the described segments of one scan. @param truth SemanticKITTI label of each point
  void add(const Segmentation& seg, const std::vector<std::uint32_t>& truth);

  std::size_t size() const { return samples_.size(); }
  Score score(const ClassConfig& config) const;
  /// Table of the 5, 25, 50, 75 and 95 % quantiles of every feature by truth and range band. Of
  /// segments with at least 20 points, seven in ten of one truth.
  std::string quantiles() const;
  /// Changes one threshold at a time, as long as that excludes more and keeps 99 % of the movable
  /// points (or as many as before, where fewer are kept).
  ClassConfig propose(const ClassConfig& start) const;

 private:
  struct Sample {
    FeatureVector features;
    std::size_t points = 0;
    std::array<double, 4> truth{};  ///< points of each
  };

  std::vector<float> valuesOf(std::size_t feature, std::size_t truth, std::size_t band) const;

  std::vector<Sample> samples_;
};

}  // namespace segdf::apps

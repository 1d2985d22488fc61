// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf {

/// How bright the same surface is in one bin of range or incidence.
struct IntensityBin {
  double from = 0.0;  ///< metres, or cosine
  double to = 0.0;
  std::size_t points = 0;
  double relative = 0.0;  ///< geometric mean of intensity over that of the surface at r_ref, cos 1
};

/// Fit of formula (6), log I = a_surface - p log(R / r_ref) + gamma log(cos alpha).
struct IntensityFit {
  double range_exponent = 0.0;      ///< p
  double incidence_exponent = 0.0;  ///< gamma
  double range_error = 0.0;         ///< standard error of p, surfaces taken as independent
  double incidence_error = 0.0;     ///< standard error of gamma
  std::vector<IntensityBin> by_range;
  std::vector<IntensityBin> by_cosine;
};

/// A profile with the reasons for it.
struct IntensityProposal {
  IntensityConfig config;
  double full_scale = 1.0;  ///< 99 % quantile of what the profile makes of the sensor's values
  bool certain = false;     ///< the fit is near the exponents of the profile, and nearer than to
                            ///< those of others by more than twice its error
};

/// Intensities of smooth surfaces over range and incidence angle, gathered from the scans of a
/// drive, from which the profile of an unknown sensor is chosen (method.md 3.5). What is compared
/// is always points of one segment: things far away are not made of what is near, so that means
/// over all of them would tell of materials.
class IntensitySamples {
 public:
  /// @param config gives r_ref and the ranges between which the model holds, r_near to r_cap
  explicit IntensitySamples(const IntensityConfig& config) : config_(config) {}

  void add(const Scan& scan, const Segmentation& seg);

  std::size_t points() const { return values_.size(); }  ///< of smooth surfaces
  std::size_t surfaces() const { return surfaces_; }     ///< that are seen in several cells
  double greatest() const { return greatest_; }          ///< intensity of any point
  /// Intensity that this share of the points does not exceed; there must be points.
  double quantile(double share) const;

  /// Least squares over the cells of each surface; none when range or angle hardly vary on them.
  std::optional<IntensityFit> fit() const;
  /// The profile whose exponents are nearest and whose scale the values fill.
  IntensityProposal propose(const IntensityFit& fit) const;

 private:
  /// Mean over the points of one surface that have nearly the same range and incidence.
  struct Cell {
    std::size_t surface = 0;
    double weight = 0.0;                          ///< points
    Eigen::Vector2d x = Eigen::Vector2d::Zero();  ///< log(R / r_ref), log(cos alpha)
    double y = 0.0;                               ///< log of the mean intensity
  };
  struct Value {
    float intensity, range, cosine;
  };

  void addSurface(const std::vector<Value>& values);
  std::vector<Cell> centred() const;
  void addBins(const Eigen::Vector2d& slope, IntensityFit& fit) const;
  IntensityProfile compensatedProfile() const;
  double filledScale(IntensityProfile profile) const;

  IntensityConfig config_;
  std::vector<Cell> cells_;
  std::vector<Value> values_;
  std::size_t surfaces_ = 0;
  double greatest_ = 0.0;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// Exponents and scale of formula (6) for one kind of sensor (method.md 3.3).
struct IntensityModel {
  double range_exponent = 0.0;      ///< p
  double incidence_exponent = 0.0;  ///< gamma
  double full_scale = 1.0;          ///< sensor value that becomes 1
  bool clip = true;                 ///< limit the result to [0, 1]
};

IntensityModel intensityModel(IntensityProfile profile);

/// What formula (6) multiplies a sensor value with, but for the scale:
///   (R / r_ref)^p / max(cos alpha, c_min)^gamma   with R limited to [r_near, r_cap].
/// @param range R, metres @param cosine of the incidence angle, none where the normal is not known:
/// the angle is left out
double calibrationGain(double range,
                       std::optional<double> cosine,
                       const IntensityModel& model,
                       const IntensityConfig& config);

/// Calibrated intensity of every point, Algorithm 1 line 2, formula (6):
///   I_cal = I / full_scale * calibrationGain()
/// Dimensionless, 0 for intensities that are negative or not finite.
std::vector<float> calibrateIntensity(const std::vector<Point>& points,
                                      const std::vector<Surface>& surfaces,
                                      const IntensityConfig& config);

}  // namespace segdf

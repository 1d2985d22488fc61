// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// Calibrated intensity of every point, Algorithm 1 line 2, formula (6):
///   I_cal = I / full_scale * (R / r_ref)^p / max(cos alpha, c_min)^gamma
/// with R limited to [r_near, r_cap] and the angle left out where the normal is not known.
/// Dimensionless, 0 for intensities that are negative or not finite.
std::vector<float> calibrateIntensity(const std::vector<Point>& points,
                                      const std::vector<Surface>& surfaces,
                                      const IntensityConfig& config);

}  // namespace segdf

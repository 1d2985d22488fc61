// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace segdf {

/// Arc tangent of y/x over the full turn, rad, in (-pi, pi]; error below 1e-5 rad (0.0006 deg), far
/// below any bin. Minimax polynomial (Abramowitz and Stegun 4.4.49) without branches, so that loops
/// over it vectorise. (0, 0) gives 0.
inline float fastAtan2(float y, float x) {
  constexpr float kPi = 3.14159265358979F;
  const float ax = std::fabs(x);
  const float ay = std::fabs(y);
  const float larger = ax > ay ? ax : ay;
  const float smaller = ax > ay ? ay : ax;
  const float t = smaller / (larger > 1e-30F ? larger : 1e-30F);
  const float s = t * t;
  float angle = ((((((((0.0028662257F * s - 0.0161657367F) * s + 0.0429096138F) * s - 0.0752896400F) * s +
                    0.1065626393F) * s - 0.1420889944F) * s + 0.1999355085F) * s - 0.3333314528F) * s + 1.0F) * t;
  angle = ay > ax ? 0.5F * kPi - angle : angle;
  angle = x < 0.0F ? kPi - angle : angle;
  return y < 0.0F ? -angle : angle;
}

}  // namespace segdf

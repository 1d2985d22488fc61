// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Angle of (x, y) in [-pi, pi], rad, for finite arguments; 0 at the origin. Within 2e-8 rad of
/// std::atan2 and several times faster: every scan asks it some hundred thousand times. Without a
/// branch: compilers make several at a time.
inline double arcTangent2(double y, double x) {
  constexpr double kPi = 3.14159265358979323846;
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  const double longer = ax > ay ? ax : ay;
  const double shorter = ax > ay ? ay : ax;
  const double t = shorter / (longer > 0.0 ? longer : 1.0);
  // atan(t) / t as a polynomial in t^2, interpolated at Chebyshev nodes of [0, 1]; summed in
  // halves, which leaves the processor less to wait for than Horner's scheme.
  const double s = t * t;
  const double s2 = s * s;
  const double s4 = s2 * s2;
  const double low =
      (0.9999999842427 - 0.3333306678071 * s) + s2 * (0.1999248357889 - 0.1420257051513 * s);
  const double high = (0.1063675411276 - 0.07495445477053 * s) +
                      s2 * (0.04258760789379 - 0.01600503078554 * s) + s4 * 0.002834064374102;
  double angle = t * (low + s4 * high);
  angle = ay > ax ? kPi / 2.0 - angle : angle;
  angle = x < 0.0 ? kPi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

/// As above in single precision, within 1e-6 rad.
inline float arcTangent2(float y, float x) {
  constexpr float kPi = 3.14159265F;
  const float ax = std::abs(x);
  const float ay = std::abs(y);
  const float longer = ax > ay ? ax : ay;
  const float shorter = ax > ay ? ay : ax;
  const float t = shorter / (longer > 0.0F ? longer : 1.0F);
  const float s = t * t;
  const float s2 = s * s;
  const float s4 = s2 * s2;
  const float low = (1.0F - 0.33333067F * s) + s2 * (0.19992483F - 0.14202571F * s);
  const float high =
      (0.10636754F - 0.07495446F * s) + s2 * (0.04258761F - 0.01600503F * s) + s4 * 0.00283406F;
  float angle = t * (low + s4 * high);
  angle = ay > ax ? 0.5F * kPi - angle : angle;
  angle = x < 0.0F ? kPi - angle : angle;
  return y < 0.0F ? -angle : angle;
}

/// Angle of (x, y) as a share of a full turn, in [0, 1].
inline double turnOf(double y, double x) {
  constexpr double kTwoPi = 2.0 * 3.14159265358979323846;
  const double turn = arcTangent2(y, x) / kTwoPi;
  return turn < 0.0 ? turn + 1.0 : turn;
}

/// Azimuth of each point as a share of a full turn, in [0, 1]; anything where it is not finite.
std::vector<double> turnsOf(const std::vector<Point>& points);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Angle of (x, y) in [-pi, pi], rad, for finite arguments; 0 at the origin. Within 2e-8 rad of
/// std::atan2, in single precision within 1e-6, and several times faster: every scan asks it some
/// hundred thousand times. Without a branch, and inline: compilers make several at a time.
template <class Real>
inline Real arcTangent2(Real y, Real x) {
  constexpr auto kPi = static_cast<Real>(3.14159265358979323846);
  const Real ax = std::abs(x);
  const Real ay = std::abs(y);
  const Real longer = ax > ay ? ax : ay;
  const Real shorter = ax > ay ? ay : ax;
  const Real t = shorter / (longer > 0 ? longer : 1);
  // atan(t) / t as a polynomial in t^2, interpolated at Chebyshev nodes of [0, 1]; summed in
  // halves, which leaves the processor less to wait for than Horner's scheme.
  constexpr auto kTerm0 = static_cast<Real>(0.9999999842427);
  constexpr auto kTerm1 = static_cast<Real>(0.3333306678071);
  constexpr auto kTerm2 = static_cast<Real>(0.1999248357889);
  constexpr auto kTerm3 = static_cast<Real>(0.1420257051513);
  constexpr auto kTerm4 = static_cast<Real>(0.1063675411276);
  constexpr auto kTerm5 = static_cast<Real>(0.07495445477053);
  constexpr auto kTerm6 = static_cast<Real>(0.04258760789379);
  constexpr auto kTerm7 = static_cast<Real>(0.01600503078554);
  constexpr auto kTerm8 = static_cast<Real>(0.002834064374102);
  const Real s = t * t;
  const Real s2 = s * s;
  const Real s4 = s2 * s2;
  const Real low = (kTerm0 - kTerm1 * s) + s2 * (kTerm2 - kTerm3 * s);
  const Real high = (kTerm4 - kTerm5 * s) + s2 * (kTerm6 - kTerm7 * s) + s4 * kTerm8;
  Real angle = t * (low + s4 * high);
  angle = ay > ax ? kPi / 2 - angle : angle;
  angle = x < 0 ? kPi - angle : angle;
  return y < 0 ? -angle : angle;
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

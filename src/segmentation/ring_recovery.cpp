// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMinRings = 4;
constexpr std::size_t kMaxRings = 130;
constexpr double kOneDirection = 0.9;
// The next ring starts about a turn back; a gap in the returns never looks like one.
constexpr double kJump = kPi;

double azimuth(const Point& p) {
  return std::atan2(static_cast<double>(p.y), static_cast<double>(p.x));
}

double elevation(const Point& p) {
  return std::atan2(static_cast<double>(p.z),
                    std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)));
}

/// Smallest signed turn from a to b.
double turn(double a, double b) { return std::remainder(b - a, 2.0 * kPi); }

/// +1 when the azimuth mostly rises from point to point, -1 when it falls.
double sweepDirection(const std::vector<Point>& points) {
  std::ptrdiff_t rising = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!isFinite(points[i]) || !isFinite(points[i - 1])) continue;
    rising += turn(azimuth(points[i - 1]), azimuth(points[i])) > 0.0 ? 1 : -1;
  }
  return rising >= 0 ? 1.0 : -1.0;
}

/// Ring of each point: a ring ends when its sweep, measured from the scan's first azimuth, starts
/// anew.
std::vector<std::int16_t> cutAtWraps(const std::vector<Point>& points) {
  const double direction = sweepDirection(points);
  std::vector<std::int16_t> rings(points.size(), -1);
  const auto first = std::find_if(points.begin(), points.end(), isFinite);
  if (first == points.end()) return rings;
  const double start = azimuth(*first);
  double previous = 0.0;
  std::int16_t ring = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isFinite(points[i])) {
      double swept = direction * (azimuth(points[i]) - start);
      // A quarter turn of margin: rings do not all begin at exactly the same azimuth.
      swept -= 2.0 * kPi * std::floor((swept + kPi / 2.0) / (2.0 * kPi));
      if (swept < previous - kJump && ring < static_cast<std::int16_t>(kMaxRings)) ++ring;
      previous = swept;
    }
    rings[i] = ring;
  }
  return rings;
}

std::vector<double> meanElevations(const std::vector<Point>& points,
                                   const std::vector<std::int16_t>& rings) {
  std::vector<double> sum(static_cast<std::size_t>(rings.back()) + 1, 0.0);
  std::vector<double> count(sum.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isFinite(points[i]) || rings[i] < 0) continue;
    sum[static_cast<std::size_t>(rings[i])] += elevation(points[i]);
    count[static_cast<std::size_t>(rings[i])] += 1.0;
  }
  for (std::size_t r = 0; r < sum.size(); ++r) sum[r] /= std::max(count[r], 1.0);
  return sum;
}

bool isPlausible(const std::vector<Point>& points, const std::vector<std::int16_t>& rings) {
  if (rings.empty() || rings.back() < 0) return false;
  const std::vector<double> elevations = meanElevations(points, rings);
  if (elevations.size() < kMinRings || elevations.size() > kMaxRings) return false;
  std::size_t falling = 0;
  for (std::size_t r = 1; r < elevations.size(); ++r)
    falling += elevations[r] < elevations[r - 1] ? 1 : 0;
  const auto pairs = static_cast<double>(elevations.size() - 1);
  const auto down = static_cast<double>(falling);
  return std::max(down, pairs - down) >= kOneDirection * pairs;
}

}  // namespace

bool recoverRings(std::vector<Point>& points) {
  const std::vector<std::int16_t> rings = cutAtWraps(points);
  if (!isPlausible(points, rings)) return false;
  for (std::size_t i = 0; i < points.size(); ++i) points[i].ring = rings[i];
  return true;
}

}  // namespace segdf

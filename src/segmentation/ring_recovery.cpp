// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMinRings = 4;
constexpr std::size_t kMaxRings = 130;
constexpr double kOneDirection = 0.9;
constexpr double kLargestShare = 0.5;
// Rings that begin where the first point lies do so within a fraction of a column.
constexpr double kStartMargin = 1e-3;  // rad

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

/// A way to cut the scan into rings, and how even they come out.
struct Cut {
  std::vector<std::int16_t> rings;
  std::vector<double> elevations;  ///< mean of each ring, rad
  double largest = 0.0;            ///< points in the largest ring
  double scatter = 0.0;            ///< squared deviations from it, summed
};

/// Cuts where the sweep, measured from the azimuth `start`, falls back by more than half a turn.
Cut cutAt(const std::vector<Point>& points, double start, double direction) {
  Cut cut;
  cut.rings.assign(points.size(), -1);
  double previous = 0.0;
  std::int16_t ring = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isFinite(points[i])) {
      double swept = direction * (azimuth(points[i]) - start);
      swept -= 2.0 * kPi * std::floor(swept / (2.0 * kPi));
      if (swept < previous - kPi && ring <= static_cast<std::int16_t>(kMaxRings)) ++ring;
      previous = swept;
    }
    cut.rings[i] = ring;
  }
  return cut;
}

void measureElevations(const std::vector<Point>& points, Cut& cut) {
  const std::size_t count = cut.rings.empty() ? 0 : static_cast<std::size_t>(cut.rings.back()) + 1;
  std::vector<double> sum(count, 0.0);
  std::vector<double> squares(count, 0.0);
  std::vector<double> number(count, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isFinite(points[i])) continue;
    const auto ring = static_cast<std::size_t>(cut.rings[i]);
    const double e = elevation(points[i]);
    sum[ring] += e;
    squares[ring] += e * e;
    number[ring] += 1.0;
  }
  for (std::size_t r = 0; r < count; ++r) {
    const double n = std::max(number[r], 1.0);
    cut.elevations.push_back(sum[r] / n);
    cut.largest = std::max(cut.largest, number[r]);
    cut.scatter += squares[r] - sum[r] * sum[r] / n;
  }
}

/// The cut with the fewest rings, since a wrong start cuts one ring more, and of these the most
/// even one.
Cut bestCut(const std::vector<Point>& points) {
  const double direction = sweepDirection(points);
  std::vector<double> starts{0.0, kPi / 2.0, kPi, -kPi / 2.0};
  const auto first = std::find_if(points.begin(), points.end(), isFinite);
  if (first != points.end()) starts.push_back(azimuth(*first) - direction * kStartMargin);
  Cut best;
  std::pair<std::size_t, double> least{~std::size_t{0}, 0.0};
  for (double start : starts) {
    Cut cut = cutAt(points, start, direction);
    measureElevations(points, cut);
    const std::pair<std::size_t, double> cost{cut.elevations.size(), cut.scatter};
    if (cost >= least) continue;
    least = cost;
    best = std::move(cut);
  }
  return best;
}

bool isPlausible(const std::vector<double>& elevations) {
  if (elevations.size() < kMinRings || elevations.size() > kMaxRings) return false;
  std::size_t falling = 0;
  for (std::size_t r = 1; r < elevations.size(); ++r) {
    falling += elevations[r] < elevations[r - 1] ? 1 : 0;
  }
  const auto pairs = static_cast<double>(elevations.size() - 1);
  const auto down = static_cast<double>(falling);
  return std::max(down, pairs - down) >= kOneDirection * pairs;
}

}  // namespace

bool recoverRings(std::vector<Point>& points) {
  const Cut cut = bestCut(points);
  if (cut.largest > kLargestShare * static_cast<double>(points.size())) return false;
  if (!isPlausible(cut.elevations)) return false;
  for (std::size_t i = 0; i < points.size(); ++i) points[i].ring = cut.rings[i];
  return true;
}

}  // namespace segdf

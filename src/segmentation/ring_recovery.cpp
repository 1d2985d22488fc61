// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::size_t kMinRings = 4;
constexpr std::size_t kMaxRings = 130;
constexpr double kOneDirection = 0.9;
constexpr double kLargestShare = 0.5;
// Rings that begin where the first point lies do so within a fraction of a column.
constexpr double kStartMargin = 1e-3;  // rad

/// Where a finite point lies, rad. Taken once: every cut looks at all of them.
struct Direction {
  double azimuth = 0.0;
  double elevation = 0.0;
};

std::vector<Direction> directionsOf(const std::vector<Point>& points) {
  std::vector<Direction> directions;
  directions.reserve(points.size());
  for (const Point& p : points) {
    if (!isFinite(p)) continue;
    const auto x = static_cast<double>(p.x);
    const auto y = static_cast<double>(p.y);
    directions.push_back(
        {arcTangent2(y, x), arcTangent2(static_cast<double>(p.z), std::sqrt(x * x + y * y))});
  }
  return directions;
}

/// +1 when the azimuth mostly rises from point to point, -1 when it falls.
double sweepDirection(const std::vector<Direction>& directions) {
  std::ptrdiff_t rising = 0;
  for (std::size_t i = 1; i < directions.size(); ++i) {
    const double turn = directions[i].azimuth - directions[i - 1].azimuth;
    // More than half a turn is the smaller one the other way round.
    rising += (turn > 0.0) == (std::abs(turn) <= kPi) && turn != 0.0 ? 1 : -1;
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
Cut cutAt(const std::vector<Direction>& directions, double start, double direction) {
  Cut cut;
  cut.rings.reserve(directions.size());
  double previous = 0.0;
  std::int16_t ring = 0;
  for (const Direction& d : directions) {
    // Azimuths and starts are less than a turn and a half apart.
    double swept = direction * (d.azimuth - start);
    if (swept < 0.0) swept += 2.0 * kPi;
    if (swept >= 2.0 * kPi) swept -= 2.0 * kPi;
    if (swept < previous - kPi && ring <= static_cast<std::int16_t>(kMaxRings)) ++ring;
    previous = swept;
    cut.rings.push_back(ring);
  }
  return cut;
}

void measureElevations(const std::vector<Direction>& directions, Cut& cut) {
  const std::size_t count = cut.rings.empty() ? 0 : static_cast<std::size_t>(cut.rings.back()) + 1;
  std::vector<double> sum(count, 0.0);
  std::vector<double> squares(count, 0.0);
  std::vector<double> number(count, 0.0);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto ring = static_cast<std::size_t>(cut.rings[i]);
    const double e = directions[i].elevation;
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
Cut bestCut(const std::vector<Direction>& directions) {
  const double direction = sweepDirection(directions);
  std::vector<double> starts{0.0, kPi / 2.0, kPi, -kPi / 2.0};
  if (!directions.empty()) {
    starts.push_back(directions.front().azimuth - direction * kStartMargin);
  }
  Cut best;
  std::pair<std::size_t, double> least{~std::size_t{0}, 0.0};
  for (double start : starts) {
    Cut cut = cutAt(directions, start, direction);
    measureElevations(directions, cut);
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
  const Cut cut = bestCut(directionsOf(points));
  if (cut.largest > kLargestShare * static_cast<double>(points.size())) return false;
  if (!isPlausible(cut.elevations)) return false;
  std::size_t next = 0;
  for (Point& p : points) p.ring = isFinite(p) ? cut.rings[next++] : std::int16_t{-1};
  return true;
}

}  // namespace segdf

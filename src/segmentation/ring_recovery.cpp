// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

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

/// Calls visit(ring) for every direction in turn: a ring ends where the sweep, measured from the
/// azimuth `start`, falls back by more than half a turn.
template <class Visit>
void forEachRing(const std::vector<Direction>& directions,
                 double start,
                 double direction,
                 const Visit& visit) {
  double previous = 0.0;
  std::int16_t ring = 0;
  for (const Direction& d : directions) {
    // Azimuths and starts are less than a turn and a half apart.
    double swept = direction * (d.azimuth - start);
    if (swept < 0.0) swept += 2.0 * kPi;
    if (swept >= 2.0 * kPi) swept -= 2.0 * kPi;
    if (swept < previous - kPi && ring <= static_cast<std::int16_t>(kMaxRings)) ++ring;
    previous = swept;
    visit(ring);
  }
}

std::int16_t lastRing(const std::vector<Direction>& directions, double start, double direction) {
  std::int16_t last = 0;
  forEachRing(directions, start, direction, [&last](std::int16_t ring) { last = ring; });
  return last;
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

Cut cutAt(const std::vector<Direction>& directions, double start, double direction) {
  Cut cut;
  cut.rings.reserve(directions.size());
  forEachRing(directions, start, direction,
              [&cut](std::int16_t ring) { cut.rings.push_back(ring); });
  measureElevations(directions, cut);
  return cut;
}

/// The cut with the fewest rings, since a wrong start cuts one ring more, and of these the most
/// even one.
Cut bestCut(const std::vector<Direction>& directions) {
  const double direction = sweepDirection(directions);
  std::vector<double> starts{0.0, kPi / 2.0, kPi, -kPi / 2.0};
  if (!directions.empty()) {
    starts.push_back(directions.front().azimuth - direction * kStartMargin);
  }
  std::vector<std::int16_t> rings;
  for (double start : starts) rings.push_back(lastRing(directions, start, direction));
  const std::int16_t fewest = *std::min_element(rings.begin(), rings.end());
  Cut best;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    if (rings[k] != fewest) continue;
    Cut cut = cutAt(directions, starts[k], direction);
    if (best.rings.empty() || cut.scatter < best.scatter) best = std::move(cut);
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

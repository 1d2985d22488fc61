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

/// Where the finite points lie, rad. Taken once: every cut looks at all of them.
struct Directions {
  std::vector<double> azimuth;
  std::vector<double> elevation;
};

Directions directionsOf(const std::vector<Point>& points) {
  Directions directions;
  directions.azimuth.reserve(points.size());
  directions.elevation.reserve(points.size());
  for (const Point& p : points) {
    if (!isFinite(p)) continue;
    const auto x = static_cast<double>(p.x);
    const auto y = static_cast<double>(p.y);
    directions.azimuth.push_back(arcTangent2(y, x));
    directions.elevation.push_back(arcTangent2(static_cast<double>(p.z), std::sqrt(x * x + y * y)));
  }
  return directions;
}

/// +1 when the azimuth mostly rises from point to point, -1 when it falls.
double sweepDirection(const std::vector<double>& azimuth) {
  std::ptrdiff_t rising = 0;
  for (std::size_t i = 1; i < azimuth.size(); ++i) {
    const double turn = azimuth[i] - azimuth[i - 1];
    // More than half a turn is the smaller one the other way round.
    rising += (turn > 0.0) == (std::abs(turn) <= kPi) && turn != 0.0 ? 1 : -1;
  }
  return rising >= 0 ? 1.0 : -1.0;
}

/// A way to cut the scan into rings, and how even they come out.
struct Cut {
  std::vector<std::size_t> begin;  ///< of each ring, among the finite points
  std::vector<double> elevations;  ///< mean of each ring, rad
  std::size_t largest = 0;         ///< points in the largest ring
  double scatter = 0.0;            ///< squared deviations from it, summed
};

/// Cuts where the sweep, measured from the azimuth `start`, falls back by more than half a turn.
Cut cutAt(const std::vector<double>& azimuth, double start, double direction) {
  Cut cut;
  if (!azimuth.empty()) cut.begin.push_back(0);
  double previous = 0.0;
  for (std::size_t i = 0; i < azimuth.size(); ++i) {
    // Azimuths and starts are less than a turn and a half apart.
    double swept = direction * (azimuth[i] - start);
    swept += swept < 0.0 ? 2.0 * kPi : 0.0;
    swept -= swept >= 2.0 * kPi ? 2.0 * kPi : 0.0;
    if (swept < previous - kPi && cut.begin.size() <= kMaxRings + 1) cut.begin.push_back(i);
    previous = swept;
  }
  return cut;
}

void measureElevations(const std::vector<double>& elevation, Cut& cut) {
  for (std::size_t r = 0; r < cut.begin.size(); ++r) {
    const std::size_t end = r + 1 < cut.begin.size() ? cut.begin[r + 1] : elevation.size();
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = cut.begin[r]; i < end; ++i) {
      sum += elevation[i];
      squares += elevation[i] * elevation[i];
    }
    const auto n = static_cast<double>(end - cut.begin[r]);
    cut.elevations.push_back(sum / n);
    cut.largest = std::max(cut.largest, end - cut.begin[r]);
    cut.scatter += squares - sum * sum / n;
  }
}

/// The cut with the fewest rings, since a wrong start cuts one ring more, and of these the most
/// even one.
Cut bestCut(const Directions& directions) {
  const double direction = sweepDirection(directions.azimuth);
  std::vector<double> starts{0.0, kPi / 2.0, kPi, -kPi / 2.0};
  if (!directions.azimuth.empty()) {
    starts.push_back(directions.azimuth.front() - direction * kStartMargin);
  }
  Cut best;
  bool any = false;
  for (double start : starts) {
    Cut cut = cutAt(directions.azimuth, start, direction);
    if (any && cut.begin.size() > best.begin.size()) continue;
    measureElevations(directions.elevation, cut);
    if (any && cut.begin.size() == best.begin.size() && cut.scatter >= best.scatter) continue;
    best = std::move(cut);
    any = true;
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
  if (static_cast<double>(cut.largest) > kLargestShare * static_cast<double>(points.size()))
    return false;
  if (!isPlausible(cut.elevations)) return false;
  std::size_t finite = 0;
  std::int16_t ring = -1;
  for (Point& p : points) {
    const auto next = static_cast<std::size_t>(ring + 1);
    if (!isFinite(p)) {
      p.ring = -1;
      continue;
    }
    if (next < cut.begin.size() && finite == cut.begin[next]) ++ring;
    p.ring = ring;
    ++finite;
  }
  return true;
}

}  // namespace segdf

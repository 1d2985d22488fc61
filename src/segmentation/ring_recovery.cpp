// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ring_recovery.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace segdf {

namespace {

constexpr std::size_t kMinRings = 4;
constexpr std::size_t kMaxRings = 130;
constexpr double kOneDirection = 0.9;
constexpr double kLargestShare = 0.5;
// Rings that begin where the first point lies do so within a fraction of a column.
constexpr float kStartMargin = 1e-3F;  // rad

/// Where the finite points lie, seen from above, and how far up. No angles are needed: their order
/// is enough.
struct Directions {
  std::vector<Eigen::Vector2f> places;  ///< metres
  std::vector<double> sines;            ///< of the elevations

  std::size_t size() const { return places.size(); }
};

Directions directionsOf(const std::vector<Point>& points) {
  Directions directions;
  directions.places.reserve(points.size());
  directions.sines.reserve(points.size());
  for (const Point& p : points) {
    if (!isFinite(p)) continue;
    const Eigen::Vector3d x = p.position().cast<double>();
    const double range = x.norm();
    directions.places.emplace_back(p.x, p.y);
    directions.sines.push_back(range > 0.0 ? x.z() / range : 0.0);
  }
  return directions;
}

/// Positive when b lies less than half a turn counter-clockwise of a.
float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// +1 when the azimuth mostly rises from point to point, -1 when it falls.
float sweepDirection(const std::vector<Eigen::Vector2f>& places) {
  std::ptrdiff_t rising = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    rising += cross(places[i - 1], places[i]) > 0.0F ? 1 : -1;
  }
  return rising >= 0 ? 1.0F : -1.0F;
}

/// A way to cut the scan into rings, and how even they come out.
struct Cut {
  Eigen::Vector2f start;           ///< the ray at which they begin
  std::vector<std::size_t> begin;  ///< of each ring, among the finite points
  std::vector<double> elevations;  ///< mean sine of each ring
  std::size_t largest = 0;         ///< points in the largest ring
  double scatter = 0.0;            ///< squared deviations from it, summed
};

/// Rings may begin at the axes, or where the first point lies.
std::vector<Cut> possibleCuts(const std::vector<Eigen::Vector2f>& places, float direction) {
  std::vector<Cut> cuts(5);
  cuts[0].start = Eigen::Vector2f::UnitX();
  cuts[1].start = Eigen::Vector2f::UnitY();
  cuts[2].start = -Eigen::Vector2f::UnitX();
  cuts[3].start = -Eigen::Vector2f::UnitY();
  cuts[4].start = Eigen::Rotation2Df(-direction * kStartMargin) * places[0];
  return cuts;
}

/// Cuts where the sweep goes on over the ray: the point before lies less than half a turn before
/// it, the point less than half a turn behind it, and less than half a turn lies between them.
void make(Cut& cut, const std::vector<Eigen::Vector2f>& places, float direction) {
  const Eigen::Vector2f across(-direction * cut.start.y(), direction * cut.start.x());
  cut.begin.push_back(0);
  float before = 0.0F;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float side = across.dot(places[i]);
    if (before < 0.0F && side >= 0.0F) {
      const bool goes_on = direction * cross(places[i - 1], places[i]) > 0.0F;
      if (goes_on && cut.begin.size() <= kMaxRings + 1) cut.begin.push_back(i);
    }
    before = side;
  }
}

void measureElevations(const std::vector<double>& sines, Cut& cut) {
  for (std::size_t r = 0; r < cut.begin.size(); ++r) {
    const std::size_t end = r + 1 < cut.begin.size() ? cut.begin[r + 1] : sines.size();
    const auto size = static_cast<Eigen::Index>(end - cut.begin[r]);
    const Eigen::Map<const Eigen::VectorXd> ring(sines.data() + cut.begin[r], size);
    const double sum = ring.sum();
    const auto n = static_cast<double>(size);
    cut.elevations.push_back(sum / n);
    cut.largest = std::max(cut.largest, end - cut.begin[r]);
    cut.scatter += ring.squaredNorm() - sum * sum / n;
  }
}

/// The cut with the fewest rings, since a wrong start cuts one ring more, and of these the most
/// even one.
Cut bestCut(const Directions& directions) {
  const float direction = sweepDirection(directions.places);
  std::vector<Cut> cuts = possibleCuts(directions.places, direction);
  std::size_t fewest = directions.size();
  for (Cut& cut : cuts) {
    make(cut, directions.places, direction);
    fewest = std::min(fewest, cut.begin.size());
  }
  Cut* best = nullptr;
  for (Cut& cut : cuts) {
    if (cut.begin.size() != fewest) continue;
    measureElevations(directions.sines, cut);
    if (best == nullptr || cut.scatter < best->scatter) best = &cut;
  }
  return *best;
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
  const Directions directions = directionsOf(points);
  if (directions.size() == 0) return false;
  const Cut cut = bestCut(directions);
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

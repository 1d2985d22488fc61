// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/sensor_recognition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <vector>

namespace segdf {

namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;
// Nearer returns come from the own vehicle, and parallax between the lasers spreads their
// elevation.
constexpr double kMinRange = 3.0;
constexpr double kBin = 0.1;          // degrees
constexpr double kOccupied = 0.05;    // share of the mean count that makes a bin occupied
constexpr std::size_t kMinRuns = 10;  // fewer runs: the lasers' elevations run into each other
constexpr int kDenseBeams = 64;
constexpr double kTrim = 0.005;
constexpr double kBeamsPenalty = 12.0;  // degrees of misfit that a factor 2 in beams counts as
constexpr double kMatch = 6.0;          // degrees of misfit up to which the guess is certain

struct KnownSensor {
  const char* name;
  int beams;
  double elevation_min;
  double elevation_max;
};

// Data sheets; OS1 in both of its fields of view.
constexpr std::array<KnownSensor, 5> kKnown{{{"hdl64", 64, -24.8, 2.0},
                                             {"hdl32", 32, -30.67, 10.67},
                                             {"vlp16", 16, -15.0, 15.0},
                                             {"os1_64", 64, -22.5, 22.5},
                                             {"os1_64", 64, -16.6, 16.6}}};

std::vector<double> elevations(const Scan& scan) {
  std::vector<double> result;
  for (const Point& p : scan.points) {
    const double flat = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
    const auto z = static_cast<double>(p.z);
    if (!isFinite(p) || std::hypot(flat, z) < kMinRange) continue;
    result.push_back(std::atan2(z, flat) * kDegrees);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Lasers told apart by the gaps between their elevations; kDenseBeams when there are no gaps.
int countBeams(const std::vector<double>& sorted) {
  const double span = sorted.back() - sorted.front();
  std::vector<std::size_t> bins(static_cast<std::size_t>(span / kBin) + 1, 0);
  for (double e : sorted) ++bins[static_cast<std::size_t>((e - sorted.front()) / kBin)];
  const double least =
      kOccupied * static_cast<double>(sorted.size()) / static_cast<double>(bins.size());
  std::size_t runs = 0;
  bool inside = false;
  for (std::size_t count : bins) {
    const bool occupied = static_cast<double>(count) > least;
    runs += occupied && !inside ? 1 : 0;
    inside = occupied;
  }
  return runs < kMinRuns ? kDenseBeams : static_cast<int>(runs);
}

int countRings(const Scan& scan) {
  std::set<std::int16_t> rings;
  for (const Point& p : scan.points) {
    if (p.ring >= 0) rings.insert(p.ring);
  }
  return static_cast<int>(rings.size());
}

double misfit(const KnownSensor& sensor, const SensorGuess& seen) {
  // Open sky hides the upper lasers, so a low upper edge tells less than a high one.
  const double above = seen.elevation_max - sensor.elevation_max;
  const double beams = std::abs(std::log2(static_cast<double>(seen.beams) / sensor.beams));
  return std::abs(seen.elevation_min - sensor.elevation_min) +
         (above > 0.0 ? above : -0.5 * above) + kBeamsPenalty * beams;
}

}  // namespace

SensorGuess recogniseSensor(const Scan& scan) {
  SensorGuess guess;
  guess.name = kKnown.front().name;
  const std::vector<double> sorted = elevations(scan);
  if (sorted.empty()) return guess;
  const auto trim = static_cast<std::size_t>(kTrim * static_cast<double>(sorted.size()));
  guess.elevation_min = sorted[trim];
  guess.elevation_max = sorted[sorted.size() - 1 - trim];
  const int rings = countRings(scan);
  guess.beams = rings > 0 ? rings : countBeams(sorted);
  double best = std::numeric_limits<double>::infinity();
  for (const KnownSensor& sensor : kKnown) {
    const double value = misfit(sensor, guess);
    if (value >= best) continue;
    best = value;
    guess.name = sensor.name;
  }
  guess.certain = best <= kMatch;
  return guess;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground_zones.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

// Patchwork++'s grid: rings and sectors of each zone.
constexpr std::array<int, ConcentricZones::kZones> kRings{2, 4, 4, 4};
constexpr std::array<int, ConcentricZones::kZones> kSectors{16, 32, 54, 32};
constexpr std::size_t kGrain = 4096;

// One line on the ground does not determine a plane, but far out two are too far apart for one.
constexpr std::ptrdiff_t kRingLasers = 2;
constexpr double kWidestRing = 15.0;  // metres
constexpr double kRadians = 3.14159265358979323846 / 180.0;

/// Borders of all rings, from the inner one of the first, metres.
std::vector<double> equalBorders(const GroundConfig& c) {
  const std::array<double, ConcentricZones::kZones + 1> zones{
      c.l_min, (7.0 * c.l_min + c.l_max) / 8.0, (3.0 * c.l_min + c.l_max) / 4.0,
      (c.l_min + c.l_max) / 2.0, c.l_max};
  std::vector<double> borders{c.l_min};
  for (std::size_t zone = 0; zone < ConcentricZones::kZones; ++zone) {
    const double width = (zones[zone + 1] - zones[zone]) / kRings[zone];
    for (int ring = 1; ring < kRings[zone]; ++ring) borders.push_back(zones[zone] + ring * width);
    borders.push_back(zones[zone + 1]);
  }
  return borders;
}

/// Where directions half-way between neighbouring lasers meet level ground, metres, ascending.
std::vector<double> betweenLasers(const RangeImageConfig& lasers, double sensor_height) {
  std::vector<double> radii;
  const double step = (lasers.elevation_max - lasers.elevation_min) / (lasers.beams - 1);
  for (int k = 0; k + 1 < lasers.beams; ++k) {
    const double down = -(lasers.elevation_min + (k + 0.5) * step) * kRadians;
    if (down > 0.0) radii.push_back(sensor_height / std::tan(down));
  }
  return radii;
}

std::ptrdiff_t nearestOf(const std::vector<double>& values, double wanted) {
  return std::min_element(
             values.begin(), values.end(),
             [wanted](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); }) -
         values.begin();
}

/// The borders moved between lasers, without those that would leave too few of them in a ring.
std::vector<double> tiedBorders(const std::vector<double>& equal,
                                const std::vector<double>& between) {
  std::vector<double> borders{equal.front()};
  std::ptrdiff_t last = -1;
  for (std::size_t k = 1; k + 1 < equal.size(); ++k) {
    const std::ptrdiff_t nearest = nearestOf(between, equal[k]);
    const double tied = between[static_cast<std::size_t>(nearest)];
    const bool enough = nearest - last >= kRingLasers || tied - borders.back() > kWidestRing;
    if (!(tied > borders.back() && tied < equal.back()) || !enough) continue;
    borders.push_back(tied);
    last = nearest;
  }
  borders.push_back(equal.back());
  return borders;
}

std::size_t zoneOfRing(int number) {
  std::size_t zone = 0;
  for (int rings = kRings[0]; number >= rings; rings += kRings[zone]) ++zone;
  return zone;
}

}  // namespace

ConcentricZones::ConcentricZones(const GroundConfig& config,
                                 const RangeImageConfig& lasers,
                                 double sensor_height)
    : begin_(config.l_min) {
  const std::vector<double> equal = equalBorders(config);
  const std::vector<double> between = betweenLasers(lasers, sensor_height);
  const bool tied = lasers.beams <= config.tie_beams && !between.empty();
  const std::vector<double> borders = tied ? tiedBorders(equal, between) : equal;
  int patches = 0;
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
    const double middle = (borders[k] + borders[k + 1]) / 2.0;
    const auto number =
        static_cast<int>(std::upper_bound(equal.begin(), equal.end(), middle) - equal.begin() - 1);
    const int sectors = kSectors[zoneOfRing(number)];
    rings_.push_back({borders[k + 1], number, sectors, patches});
    patches += sectors;
  }
}

int ConcentricZones::patchOf(const Point& p, double turn) const {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  const double r = std::sqrt(x * x + y * y);
  if (!(r > begin_ && r <= rings_.back().end)) return -1;
  std::size_t k = 0;
  while (r > rings_[k].end) ++k;
  const Ring& ring = rings_[k];
  return ring.first_patch + std::min(static_cast<int>(turn * ring.sectors), ring.sectors - 1);
}

std::size_t ConcentricZones::indexOf(int patch) const {
  std::size_t k = rings_.size() - 1;
  while (patch < rings_[k].first_patch) --k;
  return k;
}

int ConcentricZones::innerNeighbour(int patch) const {
  const std::size_t k = indexOf(patch);
  if (k == 0) return -1;
  const Ring& ring = rings_[k];
  const Ring& inner = rings_[k - 1];
  const int sector = patch - ring.first_patch;
  return inner.first_patch + (2 * sector + 1) * inner.sectors / (2 * ring.sectors);
}

int ConcentricZones::sideNeighbour(int patch, int way) const {
  const Ring& ring = rings_[indexOf(patch)];
  return ring.first_patch + (patch - ring.first_patch + way + ring.sectors) % ring.sectors;
}

int ConcentricZones::innerRings() const { return kRings[0]; }

PatchedPoints sortIntoPatches(const std::vector<Point>& points,
                              const std::vector<PointRole>& roles,
                              const std::vector<double>& turns,
                              const ConcentricZones& zones,
                              int threads) {
  std::vector<int> patch_of(points.size(), -1);
  parallelBlocks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (roles[i] != PointRole::kUnused) patch_of[i] = zones.patchOf(points[i], turns[i]);
    }
  });
  PatchedPoints sorted;
  sorted.begin.assign(static_cast<std::size_t>(zones.patches()) + 1, 0);
  for (int patch : patch_of) {
    if (patch >= 0) ++sorted.begin[static_cast<std::size_t>(patch) + 1];
  }
  for (std::size_t k = 1; k < sorted.begin.size(); ++k) sorted.begin[k] += sorted.begin[k - 1];
  sorted.points.resize(sorted.begin.back());
  std::vector<std::size_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (patch_of[i] < 0) continue;
    sorted.points[next[static_cast<std::size_t>(patch_of[i])]++] = {
        points[i].x, points[i].y, points[i].z, static_cast<std::uint32_t>(i)};
  }
  return sorted;
}

}  // namespace segdf

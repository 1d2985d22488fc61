// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/ground_zones.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/core/parallel.hpp"
#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

namespace {

// Patchwork++'s grid: rings and sectors of each zone.
constexpr std::array<int, ConcentricZones::kZones> kRings{2, 4, 4, 4};
constexpr std::array<int, ConcentricZones::kZones> kSectors{16, 32, 54, 32};
constexpr std::size_t kGrain = 4096;

}  // namespace

ConcentricZones::ConcentricZones(const GroundConfig& c)
    : borders_{c.l_min, (7.0 * c.l_min + c.l_max) / 8.0, (3.0 * c.l_min + c.l_max) / 4.0,
               (c.l_min + c.l_max) / 2.0, c.l_max} {
  int rings = 0;
  for (std::size_t zone = 0; zone < kZones; ++zone) {
    first_patch_[zone] = patches_;
    first_ring_[zone] = rings;
    patches_ += kRings[zone] * kSectors[zone];
    rings += kRings[zone];
  }
}

int ConcentricZones::patchOf(const Point& p) const {
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  const double r = std::sqrt(x * x + y * y);
  if (!(r > borders_.front() && r <= borders_.back())) return -1;
  std::size_t zone = 0;
  while (r > borders_[zone + 1]) ++zone;
  const double width = (borders_[zone + 1] - borders_[zone]) / kRings[zone];
  const int ring = std::min(static_cast<int>((r - borders_[zone]) / width), kRings[zone] - 1);
  const int sector = std::min(static_cast<int>(turnOf(y, x) * kSectors[zone]), kSectors[zone] - 1);
  return first_patch_[zone] + ring * kSectors[zone] + sector;
}

std::size_t ConcentricZones::zoneOf(int patch) const {
  std::size_t zone = kZones - 1;
  while (patch < first_patch_[zone]) --zone;
  return zone;
}

int ConcentricZones::ringOf(int patch) const {
  const std::size_t zone = zoneOf(patch);
  return first_ring_[zone] + (patch - first_patch_[zone]) / kSectors[zone];
}

int ConcentricZones::innerNeighbour(int patch) const {
  const std::size_t zone = zoneOf(patch);
  const int inner = patch - kSectors[zone];
  if (inner >= first_patch_[zone]) return inner;
  if (zone == 0) return -1;
  const int sector = patch - first_patch_[zone];
  const int inner_sector = (2 * sector + 1) * kSectors[zone - 1] / (2 * kSectors[zone]);
  return first_patch_[zone] - kSectors[zone - 1] + inner_sector;
}

int ConcentricZones::innerRings() const { return kRings[0]; }

PatchedPoints sortIntoPatches(const std::vector<Point>& points,
                              const std::vector<PointRole>& roles,
                              const ConcentricZones& zones,
                              int threads) {
  std::vector<int> patch_of(points.size(), -1);
  parallelBlocks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (roles[i] != PointRole::kUnused) patch_of[i] = zones.patchOf(points[i]);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/ground.hpp"

#include <algorithm>
#include <cmath>

namespace segdf {

namespace {

constexpr double kRounding = 6.0;  // metres over which a grade sets in

/// 0 below 0, x well above, and a parabola between: the way climbed since the grade's foot.
double roundedRamp(double x) {
  const double half = kRounding / 2.0;
  if (x <= -half) return 0.0;
  if (x >= half) return x;
  return (x + half) * (x + half) / (2.0 * kRounding);
}

}  // namespace

bool Terrain::inJunction(double along, double margin) const {
  return std::any_of(junctions.begin(), junctions.end(),
                     [&](double at) { return std::abs(along - at) < half_junction + margin; });
}

std::uint16_t Terrain::classAt(const StreetPoint& point) const {
  if (std::abs(point.across) <= half_lanes || inJunction(point.along)) return kRoad;
  if (std::abs(point.across) <= half_road) return kParking;
  return std::abs(point.across) <= half_street ? kSidewalk : kTerrain;
}

double Terrain::heightAt(double x, double y) const { return heightAt(x, y, line.nearest(x, y)); }

double Terrain::heightAt(double x, double y, const StreetPoint& point) const {
  // Two long waves that do not repeat together within a drive.
  double height = undulation * (0.6 * std::sin(x / 11.0) + 0.4 * std::sin(x / 27.0 + y / 15.0));
  for (const Grade& grade : grades) {
    // A plane of the land, not of the street: terrain and street meet everywhere.
    const Place foot = line.place({grade.from, 0.0});
    const double way = (x - foot.x) * std::cos(foot.yaw) + (y - foot.y) * std::sin(foot.yaw);
    height +=
        grade.percent / 100.0 * (roundedRamp(way) - roundedRamp(way - (grade.to - grade.from)));
  }
  if (std::abs(point.across) > half_road && !inJunction(point.along)) height += kerb;
  return height;
}

}  // namespace segdf

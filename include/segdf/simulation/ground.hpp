// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/simulation/centre_line.hpp"

namespace segdf {

/// A stretch on which the land rises along the street's heading at its begin.
struct Grade {
  double from = 0.0;     ///< metres along
  double to = 0.0;       ///< metres along
  double percent = 0.0;  ///< rise per length
};

/// Road, kerbs, sidewalks and the land around, as a height over the map plane.
struct Terrain {
  // SemanticKITTI's classes.
  static constexpr std::uint16_t kRoad = 40;
  static constexpr std::uint16_t kParking = 44;
  static constexpr std::uint16_t kSidewalk = 48;
  static constexpr std::uint16_t kTerrain = 72;

  CentreLine line;
  std::vector<Grade> grades;
  std::vector<double> junctions;  ///< metres along: a side street without kerbs crosses
  double undulation = 0.15;       ///< amplitude, metres
  double kerb = 0.12;             ///< height of the sidewalk over the road, metres
  double half_lanes = 4.6;        ///< beyond: parking places
  double half_road = 7.0;         ///< kerbs stand this far from the centre line, metres
  double half_street = 11.5;      ///< sidewalks reach to here
  double half_junction = 6.0;     ///< half the width of a side street
  double begin = -100.0;          ///< metres along, first
  double end = 240.0;             ///< metres along, last
  double reach = 70.0;            ///< across, metres

  /// Metres.
  double heightAt(double x, double y) const;
  /// As above where the street point is known.
  double heightAt(double x, double y, const StreetPoint& point) const;
  /// Within `margin` metres of a side street.
  bool inJunction(double along, double margin = 0.0) const;
  /// Road, parking, sidewalk or terrain.
  std::uint16_t classAt(const StreetPoint& point) const;
};

}  // namespace segdf

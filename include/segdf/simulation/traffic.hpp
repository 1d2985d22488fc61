// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "segdf/simulation/route.hpp"
#include "segdf/simulation/scene.hpp"

namespace segdf {

/// A stop on one's own way.
struct Halt {
  double at = 0.0;        ///< metres of way from the begin
  double duration = 0.0;  ///< seconds
};

/// A traffic light over the street.
struct Light {
  double at = 0.0;                             ///< metres along, the middle of the crossing
  std::vector<std::pair<double, double>> red;  ///< seconds, from and to
};

/// Someone on the way: the ego vehicle, another vehicle, a cyclist, someone on foot.
struct RoadUser {
  explicit RoadUser(Route way) : route(std::move(way)) {}

  Route route;
  double length = 4.4;  ///< of the footprint, metres
  double width = 1.8;   ///< metres
  double speed = 8.0;   ///< wanted, m/s
  double start = 0.0;   ///< seconds; with 0 it is under way already, else it sets out from rest
  std::vector<Halt> halts;
  bool obeys_lights = false;
};

/// Moves all of them together, in steps of 0.1 s, from 0 to `duration` seconds: they speed up and
/// brake with bounded acceleration, slow down for turns, halt where told and at red lights, and
/// wait for whatever stands or goes ahead of them on their own way, so that nobody drives through
/// anybody. Gives one path for each, of a single way point for who never moved.
/// @param stop_distance from the middle of a crossing to its stop line, metres
std::vector<std::vector<WayPoint>> driveTogether(const std::vector<RoadUser>& users,
                                                 const std::vector<Light>& lights,
                                                 double stop_distance,
                                                 double duration);

}  // namespace segdf

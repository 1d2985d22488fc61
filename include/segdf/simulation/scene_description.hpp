// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "segdf/simulation/ground.hpp"
#include "segdf/simulation/objects.hpp"
#include "segdf/simulation/traffic.hpp"

namespace segdf {

/// Bounds of a value that is drawn anew for each use.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
};

/// What a street is made of. Numbers of things are per 100 m and side.
struct StreetDescription {
  double length = 120.0;  ///< metres that the ego may drive; the street goes on at both ends
  std::vector<Bend> bends;
  std::vector<Grade> grades;
  double undulation = 0.15;  ///< metres
  double kerb = 0.12;        ///< metres
  std::vector<double> junctions;
  std::vector<Light> lights;
  double houses = 0.8;  ///< share of the front that is built up
  double trees = 8.0;
  double bushes = 30.0;
  double poles = 3.0;
  double signs = 1.0;
  double bollards = 2.0;
  double hedges = 8.0;
  double fences = 3.0;
  double people = 2.0;          ///< who stand
  double parked = 0.6;          ///< share of the parking places that are taken
  Bounds parked_gap{0.4, 2.5};  ///< between bumpers, metres
};

struct EgoDescription {
  std::vector<StreetPoint> path;  ///< empty: along its lane from 0 to the street's length
  double speed = 8.0;             ///< m/s
  double start = 0.0;             ///< seconds
  std::vector<Halt> halts;
};

/// One thing that goes its own way.
struct MoverDescription {
  ObjectKind kind = ObjectKind::kCar;
  std::vector<StreetPoint> path;
  double speed = 8.0;  ///< m/s
  double start = 0.0;  ///< seconds; until then it stands at the begin of its path
  std::vector<Halt> halts;
  bool lights = true;  ///< vehicles and cyclists: stops at red
};

/// Many of a kind on one line along the street, as long as the drive lasts.
struct FlowDescription {
  std::vector<ObjectKind> kinds;  ///< drawn with equal chances
  double lane = 1.75;             ///< metres across
  bool forward = true;            ///< in the direction of the street
  Bounds speed{7.0, 7.0};         ///< m/s
  Bounds gap{15.0, 30.0};         ///< metres between one and the next
  bool lights = true;
};

/// A thing that stands at a given place.
struct ThingDescription {
  ObjectKind kind = ObjectKind::kCar;
  StreetPoint at;
  double heading = 0.0;  ///< rad, against the street's
  ObjectSize size;
};

/// What a scene file says (docs/simulator.md).
struct SceneDescription {
  double duration = 15.0;          ///< seconds
  std::string sensor;              ///< the one that the scene is meant for; empty: any
  double pose_noise = 0.02;        ///< sigma per axis, metres
  double pose_noise_angle = 0.05;  ///< sigma per axis, degrees
  double pose_drift = 0.0;         ///< error per way driven, percent
  Bounds dropout;                  ///< share of pulses lost beside the sensor's own, per scan
  StreetDescription street;
  EgoDescription ego;
  std::vector<MoverDescription> movers;
  std::vector<FlowDescription> flows;
  std::vector<ThingDescription> things;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "segdf/simulation/random.hpp"
#include "segdf/simulation/world.hpp"

namespace segdf {

/// How intensity is made from reflectance, range and angle (method.md 8.2).
enum class SimulatedIntensity {
  kKitti,         ///< 0..0.99 in steps of 0.01, compensated but for a mild hump over range
  kReflectivity,  ///< 0..255; 0..100 diffuse, above retro-reflectors
  kByte,          ///< 0..255, linear in reflectance
  kRaw,           ///< 0..1, falls with the square of the range and the incidence angle
};

/// The roof that the sensor stands on, in the sensor's frame: what hits it does not come back.
struct OwnRoof {
  double rear = -1.8;   ///< x, metres
  double front = 0.8;   ///< x, metres
  double side = 0.5;    ///< +-y, metres
  double depth = 0.35;  ///< below the sensor, metres
};

/// A spinning LiDAR.
struct SensorModel {
  std::string name;
  std::vector<double> elevations;  ///< degrees, topmost laser first
  int columns = 1800;              ///< azimuth steps over a turn
  double height = 1.73;            ///< over the ground, metres
  double reach = 80.0;             ///< metres, for a reflectance of 0.2 and more
  SimulatedIntensity intensity = SimulatedIntensity::kReflectivity;
  double range_noise = 0.015;   ///< sigma, metres
  double range_bias = 0.015;    ///< sigma of the constant error of each laser, metres
  double angular_noise = 0.02;  ///< sigma, degrees
  double dropout = 0.02;        ///< share of pulses lost anywhere
  double gain_scatter = 0.15;   ///< sigma of the constant gain of each laser, relative
  OwnRoof roof;
  double edge_mixing = 0.1;  ///< share of pulses at a depth step whose echo lies in between
};

/// "hdl64", "hdl32", "vlp16" or "os1_64" with the beam tables of method.md 8.2.
/// @throws std::invalid_argument naming the known ones
SensorModel sensorModel(const std::string& name);

/// Intensity of a return in the sensor's unit. @param gain of the laser, about 1
float modelIntensity(const SensorModel& sensor, const RayHit& hit, double gain, Random& random);

/// True when a beam of this direction (sensor frame) goes into the own roof.
bool hitsRoof(const OwnRoof& roof, const Eigen::Vector3d& ray);

/// What becomes of the pulse of a hit.
enum class Fate {
  kReturned,
  kLost,     ///< chance, dark surface at a grazing angle, or too far for its reflectance
  kThrough,  ///< it goes on behind glass
};

Fate fateOf(const SensorModel& sensor, const RayHit& hit, Random& random);

}  // namespace segdf

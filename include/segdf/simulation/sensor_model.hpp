// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "segdf/simulation/random.hpp"
#include "segdf/simulation/world.hpp"

namespace segdf {

/// How intensity is made from reflectance, range and angle (method.md 8.2).
enum class SimulatedIntensity {
  kKitti,         ///< 0..0.99 in steps of 0.01, compensated but for a mild hump over range
  kReflectivity,  ///< 0..255; 0..100 diffuse, above retro-reflectors
  kByte,          ///< 0..255, linear in reflectance
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
};

/// "hdl64", "hdl32", "vlp16" or "os1_64" with the beam tables of method.md 8.2.
/// @throws std::invalid_argument naming the known ones
SensorModel sensorModel(const std::string& name);

/// Intensity of a return in the sensor's unit. @param gain of the laser, about 1
float modelIntensity(const SensorModel& sensor, const RayHit& hit, double gain, Random& random);

/// True when the pulse of this hit does not come back: chance, dark surface at a grazing angle,
/// glass, or too far for its reflectance.
bool isLost(const SensorModel& sensor, const RayHit& hit, Random& random);

}  // namespace segdf

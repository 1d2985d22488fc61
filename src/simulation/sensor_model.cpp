// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/sensor_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace segdf {

namespace {

constexpr double kKittiAngleExponent = 0.15;
constexpr double kIntensityNoise = 0.03;
constexpr double kGlassReturns = 0.3;
constexpr double kGlassLosses = 0.35;    // mirrored away; the rest goes through
constexpr double kDark = 0.08;           // reflectance below which grazing pulses are lost
constexpr double kGrazing = 0.3;         // cosine of the incidence angle
constexpr double kFullReach = 0.2;       // reflectance that is seen at full reach
constexpr double kRawRange = 10.0;       // metres: nearer, the receiver is out of focus
constexpr double kRetroreflector = 1.0;  // reflectance above

/// Measured on KITTI's HDL-64E, rings from the top (method.md 8.2).
std::vector<double> hdl64Elevations() {
  return {2.66,   2.29,   2.04,   1.60,   1.32,   0.92,   0.64,   0.27,   -0.07,  -0.47,  -0.77,
          -1.10,  -1.46,  -1.79,  -2.10,  -2.45,  -2.74,  -3.11,  -3.37,  -3.79,  -4.07,  -4.44,
          -4.73,  -5.06,  -5.46,  -5.78,  -6.10,  -6.38,  -6.75,  -7.11,  -7.34,  -7.73,  -8.36,
          -8.89,  -9.35,  -9.75,  -10.21, -10.82, -11.31, -11.73, -12.18, -12.60, -13.13, -13.64,
          -14.21, -14.64, -15.14, -15.50, -16.12, -16.65, -17.21, -17.67, -18.16, -18.58, -19.02,
          -19.58, -20.08, -20.72, -21.19, -21.62, -22.05, -22.69, -23.15, -23.68};
}

std::vector<double> evenElevations(int beams, double top, double bottom) {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(beams));
  for (int k = 0; k < beams; ++k) result.push_back(top + (bottom - top) * k / (beams - 1));
  return result;
}

/// KITTI's building intensity over range, relative: .85 at 5 m, 1 at 12 m, .7 at 35 m
/// (method.md 8.2).
double kittiHump(double range) {
  if (range < 12.0) return 0.85 + 0.15 * std::max(0.0, range - 5.0) / 7.0;
  return std::max(0.5, 1.0 - 0.3 * (range - 12.0) / 23.0);
}

}  // namespace

SensorModel sensorModel(const std::string& name) {
  SensorModel sensor;
  sensor.name = name;
  if (name == "hdl64") {
    sensor.elevations = hdl64Elevations();
    sensor.columns = 2083;
    sensor.intensity = SimulatedIntensity::kKitti;
  } else if (name == "hdl32") {
    sensor.elevations = evenElevations(32, 10.67, -30.67);
    sensor.columns = 1084;
    sensor.height = 1.84;
  } else if (name == "vlp16") {
    sensor.elevations = evenElevations(16, 15.0, -15.0);
    sensor.columns = 1800;
  } else if (name == "os1_64") {
    sensor.elevations = evenElevations(64, 22.5, -22.5);
    sensor.columns = 1024;
    sensor.intensity = SimulatedIntensity::kByte;
  } else {
    throw std::invalid_argument("unknown sensor '" + name +
                                "'; known are: hdl64, hdl32, vlp16, os1_64");
  }
  return sensor;
}

float modelIntensity(const SensorModel& sensor, const RayHit& hit, double gain, Random& random) {
  const auto reflectance = static_cast<double>(hit.material.reflectance);
  const double noise = kIntensityNoise * random.normal();
  if (sensor.intensity == SimulatedIntensity::kKitti) {
    const double angle = std::pow(std::max(hit.cos_incidence, 1e-3), kKittiAngleExponent);
    const double value = gain * reflectance * angle * kittiHump(hit.range) + noise;
    return static_cast<float>(std::round(100.0 * std::clamp(value, 0.0, 0.99)) / 100.0);
  }
  if (sensor.intensity == SimulatedIntensity::kRaw) {
    const double fall = kRawRange / std::max(hit.range, kRawRange);
    const double value = gain * reflectance * hit.cos_incidence * fall * fall;
    return static_cast<float>(std::clamp(value + noise * fall * fall, 0.0, 1.0));
  }
  const bool retro = reflectance > kRetroreflector;
  double value = 100.0 * (gain * reflectance + noise);
  if (sensor.intensity == SimulatedIntensity::kByte) value *= 2.55;
  if (sensor.intensity == SimulatedIntensity::kReflectivity && !retro)
    value = std::min(value, 100.0);
  return static_cast<float>(std::round(std::clamp(value, 0.0, 255.0)));
}

bool hitsRoof(const OwnRoof& roof, const Eigen::Vector3d& ray) {
  if (ray.z() >= 0.0) return false;
  const double way = -roof.depth / ray.z();
  return std::abs(ray.y() * way) < roof.side && ray.x() * way > roof.rear &&
         ray.x() * way < roof.front;
}

Fate fateOf(const SensorModel& sensor, const RayHit& hit, Random& random) {
  const auto reflectance = static_cast<double>(hit.material.reflectance);
  if (hit.material.glass) {
    const double draw = random.uniform();
    if (draw < kGlassReturns) return Fate::kReturned;
    return draw < kGlassReturns + kGlassLosses ? Fate::kLost : Fate::kThrough;
  }
  if (random.chance(sensor.dropout)) return Fate::kLost;
  if (reflectance < kDark && hit.cos_incidence < kGrazing && random.chance(0.5)) {
    return Fate::kLost;
  }
  const double reach = sensor.reach * std::sqrt(std::min(1.0, reflectance / kFullReach));
  return hit.range > reach ? Fate::kLost : Fate::kReturned;
}

}  // namespace segdf

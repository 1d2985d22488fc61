// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/intensity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace segdf {

namespace {

constexpr double kVelodyneDiffuse = 100.0;  // above: retro-reflectors
constexpr double kByte = 255.0;

std::optional<double> cosineOf(const Eigen::Vector3d& x, const Surface& surface) {
  if (!surface.hasNormal() || !(x.norm() > 0.0)) return std::nullopt;
  return std::abs(surface.normal.cast<double>().dot(x)) / x.norm();
}

}  // namespace

IntensityModel intensityModel(IntensityProfile profile) {
  switch (profile) {
    case IntensityProfile::kKittiHdl64:
      return {0.0, 0.0, 1.0, true};
    case IntensityProfile::kVelodyneReflectivity:
      return {0.0, 0.0, kVelodyneDiffuse, true};
    case IntensityProfile::kOusterReflectivity:
      return {0.0, 0.0, kByte, true};
    case IntensityProfile::kOusterSignal:
      // Photon counts; 1024 spans what a diffuse target returns at r_ref. Not tested on real
      // counts.
      return {2.0, 1.0, 1024.0, true};
    case IntensityProfile::kRaw:
      return {2.0, 1.0, 1.0, true};
    case IntensityProfile::kLiteral:
      break;
  }
  return {2.0, 1.0, 1.0, false};
}

double calibrationGain(double range,
                       std::optional<double> cosine,
                       const IntensityModel& model,
                       const IntensityConfig& config) {
  double gain = 1.0;
  if (model.range_exponent != 0.0) {
    const double limited = std::min(std::max(range, config.r_near), config.r_cap);
    gain *= std::pow(limited / config.r_ref, model.range_exponent);
  }
  if (model.incidence_exponent != 0.0 && cosine) {
    gain /= std::pow(std::max(*cosine, config.c_min), model.incidence_exponent);
  }
  return gain;
}

std::vector<float> calibrateIntensity(const std::vector<Point>& points,
                                      const std::vector<Surface>& surfaces,
                                      const IntensityConfig& config) {
  const IntensityModel model = intensityModel(config.profile);
  const double scale = config.full_scale > 0.0 ? config.full_scale : model.full_scale;
  const bool by_angle = model.incidence_exponent != 0.0;
  std::vector<float> result(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].intensity) || !isFinite(points[i])) continue;
    const Eigen::Vector3d x = points[i].position().cast<double>();
    const auto cosine = by_angle ? cosineOf(x, surfaces[i]) : std::nullopt;
    const double value = std::max(0.0, static_cast<double>(points[i].intensity)) / scale *
                         calibrationGain(x.norm(), cosine, model, config);
    result[i] = static_cast<float>(model.clip ? std::min(value, 1.0) : value);
  }
  return result;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/intensity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace segdf {

namespace {

constexpr double kVelodyneDiffuse = 100.0;  // above: retro-reflectors
constexpr double kByte = 255.0;

double calibrate(const Point& point,
                 const Surface& surface,
                 const IntensityModel& model,
                 const IntensityConfig& config) {
  double value = std::max(0.0, static_cast<double>(point.intensity)) / model.full_scale;
  const Eigen::Vector3d x = point.position().cast<double>();
  const double range = x.norm();
  if (model.range_exponent != 0.0) {
    const double limited = std::min(std::max(range, config.r_near), config.r_cap);
    value *= std::pow(limited / config.r_ref, model.range_exponent);
  }
  if (model.incidence_exponent != 0.0 && surface.hasNormal() && range > 0.0) {
    const double cosine = std::abs(surface.normal.cast<double>().dot(x)) / range;
    value /= std::pow(std::max(cosine, config.c_min), model.incidence_exponent);
  }
  return model.clip ? std::min(value, 1.0) : value;
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

std::vector<float> calibrateIntensity(const std::vector<Point>& points,
                                      const std::vector<Surface>& surfaces,
                                      const IntensityConfig& config) {
  const IntensityModel model = intensityModel(config.profile);
  std::vector<float> result(points.size(), 0.0F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].intensity) || !isFinite(points[i])) continue;
    result[i] = static_cast<float>(calibrate(points[i], surfaces[i], model, config));
  }
  return result;
}

}  // namespace segdf

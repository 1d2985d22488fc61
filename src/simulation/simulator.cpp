// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/simulator.hpp"

#include <cmath>

#include "segdf/core/parallel.hpp"
#include "segdf/simulation/random.hpp"
#include "segdf/simulation/street.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadians = kPi / 180.0;
// Streams of random numbers, kept apart from those of rays, which count up from 0.
constexpr std::uint64_t kLaserStream = ~std::uint64_t{0};
constexpr std::uint64_t kPoseStream = kLaserStream - 1;

Scene streetFor(const SimulationConfig& config) {
  StreetConfig street;
  street.seed = config.seed;
  street.speed = config.speed;
  street.duration = static_cast<double>(config.scans) / config.rate;
  return makeStreetScene(street);
}

}  // namespace

Simulator::Simulator(const SimulationConfig& config) : Simulator(config, streetFor(config)) {}

Simulator::Simulator(const SimulationConfig& config, const Scene& scene)
    : config_(config), sensor_(sensorModel(config.sensor)), scene_(scene), world_(scene) {
  for (std::size_t row = 0; row < sensor_.elevations.size(); ++row) {
    Random random(config.seed, kLaserStream, row);
    lasers_.push_back(
        {sensor_.range_bias * random.normal(), 1.0 + sensor_.gain_scatter * random.normal()});
  }
}

Pose Simulator::sensorPose(double time) const {
  return scene_.poseAt(interpolate(scene_.ego, time)) *
         Eigen::Translation3d(0.0, 0.0, sensor_.height);
}

Pose Simulator::disturbed(const Pose& exact) const {
  Random random(config_.seed, kPoseStream, index_);
  Pose pose = exact;
  for (Eigen::Index k = 0; k < 3; ++k) {
    pose.translation()[k] += config_.pose_noise * random.normal();
    const double angle = config_.pose_noise_angle * kRadians * random.normal();
    pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(k)));
  }
  return pose;
}

Simulator::Return Simulator::shoot(const Pose& pose, std::size_t row, std::size_t column) const {
  Random random(config_.seed, index_, row * static_cast<std::size_t>(sensor_.columns) + column);
  const double jitter = sensor_.angular_noise;
  const double elevation = (sensor_.elevations[row] + jitter * random.normal()) * kRadians;
  // Half a step of margin keeps the first and last column of a ring on their side of the seam.
  const double step = 2.0 * kPi / sensor_.columns;
  const double azimuth =
      (static_cast<double>(column) + 0.5) * step +
      std::fmax(-0.49 * step, std::fmin(0.49 * step, jitter * kRadians * random.normal()));
  const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                            std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const auto hit = world_.cast(pose.translation(), pose.linear() * ray, sensor_.reach);
  if (!hit || isLost(sensor_, *hit, random)) return {};
  const double range = hit->range + lasers_[row].bias + sensor_.range_noise * random.normal();
  const Eigen::Vector3f x = (ray * range).cast<float>();
  Return result;
  result.point = {x.x(), x.y(),
                  x.z(), modelIntensity(sensor_, *hit, lasers_[row].gain, random),
                  0.0F,  static_cast<std::int16_t>(row)};
  result.label = hit->material.label;
  result.valid = range > 0.0;
  return result;
}

std::optional<SimulatedScan> Simulator::next() {
  if (index_ == config_.scans) return std::nullopt;
  const double time = static_cast<double>(index_) / config_.rate;
  world_.moveTo(time);
  SimulatedScan result;
  result.exact_pose = sensorPose(time);
  const auto columns = static_cast<std::size_t>(sensor_.columns);
  std::vector<Return> returns(sensor_.elevations.size() * columns);
  parallelFor(sensor_.elevations.size(), config_.threads, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      returns[row * columns + column] = shoot(result.exact_pose, row, column);
    }
  });
  for (const Return& r : returns) {
    if (!r.valid) continue;
    result.scan.points.push_back(r.point);
    result.truth.push_back(r.label);
  }
  result.scan.stamp_ns = std::llround(time * 1e9);
  result.scan.pose = disturbed(result.exact_pose);
  ++index_;
  return result;
}

}  // namespace segdf

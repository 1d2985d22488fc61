// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/simulator.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/core/parallel.hpp"
#include "segdf/simulation/scene_builder.hpp"
#include "segdf/simulation/scene_yaml.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kRadians = kPi / 180.0;
// Streams of random numbers, kept apart from those of rays, which count up from 0.
constexpr std::uint64_t kLaserStream = ~std::uint64_t{0};
constexpr std::uint64_t kPoseStream = kLaserStream - 1;
constexpr std::uint64_t kDriftStream = kLaserStream - 2;
constexpr std::uint64_t kDropoutStream = kLaserStream - 3;
constexpr std::uint64_t kEdgeStream = kLaserStream - 4;
constexpr std::size_t kSlices = 36;  // of a skewed sweep
constexpr double kMaxEdge = 4.0;     // metres: echoes farther apart are told apart
constexpr float kMinEdge = 0.5F;     // metres
constexpr int kMaxPanes = 3;         // of glass that a beam goes through

double durationOf(const SimulationConfig& config, const SceneDescription& description) {
  return config.scans ? static_cast<double>(*config.scans) / config.rate : description.duration;
}

SceneDescription describe(const SimulationConfig& config) {
  SceneDescription description = loadScene(config.scene);
  if (config.speed) description.ego.speed = *config.speed;
  return description;
}

SensorModel sensorFor(const SimulationConfig& config, const SceneDescription& description) {
  const std::string& wanted = config.sensor.empty() ? description.sensor : config.sensor;
  SensorModel sensor = sensorModel(wanted.empty() ? "hdl64" : wanted);
  if (config.intensity) sensor.intensity = *config.intensity;
  return sensor;
}

Scene inSight(Scene scene, double duration, double step) {
  settleSight(scene, duration, step);
  return scene;
}

}  // namespace

Simulator::Simulator(const SimulationConfig& config) : Simulator(config, describe(config)) {}

Simulator::Simulator(const SimulationConfig& config, const SceneDescription& description)
    : Simulator(
          config,
          description,
          // A sweep more than the scans: a skewed one takes its time.
          buildScene(description, config.seed, durationOf(config, description) + 1.0 / config.rate),
          static_cast<std::size_t>(std::llround(durationOf(config, description) * config.rate))) {}

Simulator::Simulator(const SimulationConfig& config, const Scene& scene, std::size_t scans)
    : Simulator(config, SceneDescription{}, scene, scans) {}

Simulator::Simulator(const SimulationConfig& config,
                     const SceneDescription& description,
                     const Scene& scene,
                     std::size_t scans)
    : config_(config),
      description_(description),
      sensor_(sensorFor(config, description)),
      scene_(inSight(scene, static_cast<double>(scans) / config.rate, 1.0 / config.rate)),
      scans_(scans),
      world_(scene_) {
  prepare();
}

void Simulator::prepare() {
  for (std::size_t row = 0; row < sensor_.elevations.size(); ++row) {
    Random random(config_.seed, kLaserStream, row);
    const double elevation = sensor_.elevations[row] * kRadians;
    const double bias = sensor_.range_bias * random.normal();
    const double gain = 1.0 + sensor_.gain_scatter * random.normal();
    lasers_.push_back({bias, gain, std::cos(elevation), std::sin(elevation)});
  }
  for (int column = 0; column < sensor_.columns; ++column) {
    // Half a step of margin keeps the first and last column of a ring on their side of the seam.
    const double azimuth = (column + 0.5) * 2.0 * kPi / sensor_.columns;
    columns_.push_back({std::cos(azimuth), std::sin(azimuth)});
  }
}

Pose Simulator::sensorPose(double time) const {
  return scene_.poseAt(interpolate(scene_.ego, time), kEgoLength, kEgoWidth, false) *
         Eigen::Translation3d(0.0, 0.0, sensor_.height);
}

Pose Simulator::disturbed(const Pose& exact, double time) const {
  const double noise = config_.pose_noise.value_or(description_.pose_noise);
  const double noise_angle = config_.pose_noise_angle.value_or(description_.pose_noise_angle);
  const double drift = config_.pose_drift.value_or(description_.pose_drift) / 100.0;
  Random random(config_.seed, kPoseStream, index_);
  Random drift_random(config_.seed, kDriftStream);
  const double heading = drift_random.uniform(0.0, 2.0 * kPi);
  const double way = drift * interpolate(scene_.ego, time).way;
  Pose pose = exact;
  pose.pretranslate(Eigen::Vector3d(way * std::cos(heading), way * std::sin(heading), 0.3 * way));
  for (Eigen::Index k = 0; k < 3; ++k) {
    pose.translation()[k] += noise * random.normal();
    const double angle = noise_angle * kRadians * random.normal();
    pose.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(k)));
  }
  return pose;
}

double Simulator::timeOf(std::size_t column) const {
  if (!config_.skewed) return 0.0;
  return static_cast<double>(column) / static_cast<double>(columns_.size()) / config_.rate;
}

std::vector<Simulator::Slice> Simulator::slices(double time) const {
  if (!config_.skewed) return {{0, columns_.size(), time}};
  std::vector<Slice> result;
  for (std::size_t k = 0; k < kSlices; ++k) {
    const std::size_t begin = k * columns_.size() / kSlices;
    const std::size_t end = (k + 1) * columns_.size() / kSlices;
    result.push_back({begin, end, time + timeOf((begin + end) / 2)});
  }
  return result;
}

Eigen::Vector3d Simulator::direction(std::size_t row, std::size_t column, Random& random) const {
  const Laser& laser = lasers_[row];
  const Column& c = columns_[column];
  const double jitter = sensor_.angular_noise * kRadians;
  const double margin = 0.49 * 2.0 * kPi / sensor_.columns;
  // Of the first order in the jitter: the rest is below a millimetre at 100 m.
  const double up = jitter * random.normal();
  const double aside = std::clamp(jitter * random.normal(), -margin, margin);
  const double flat = laser.cos_elevation - up * laser.sin_elevation;
  return {flat * (c.cos_azimuth - aside * c.sin_azimuth),
          flat * (c.sin_azimuth + aside * c.cos_azimuth),
          laser.sin_elevation + up * laser.cos_elevation};
}

Simulator::Return Simulator::shoot(const Pose& pose,
                                   std::size_t row,
                                   std::size_t column,
                                   double dropout) const {
  Random random(config_.seed, index_, row * columns_.size() + column);
  const Eigen::Vector3d ray = direction(row, column, random);
  const Eigen::Vector3d map_ray = pose.linear() * ray;
  if (random.chance(dropout) || hitsRoof(sensor_.roof, ray)) return {};
  RayHit hit;
  double before = 0.0;
  for (int pane = 0; pane <= kMaxPanes; ++pane) {
    const auto next =
        world_.cast(pose.translation() + before * map_ray, map_ray, sensor_.reach - before);
    if (!next) return {};
    hit = *next;
    hit.range += before;
    const Fate fate = fateOf(sensor_, hit, random);
    if (fate == Fate::kLost) return {};
    if (fate == Fate::kReturned) break;
    if (pane == kMaxPanes) return {};
    before = hit.range;
  }
  const double range = hit.range + lasers_[row].bias + sensor_.range_noise * random.normal();
  if (range <= 0.0) return {};
  const Eigen::Vector3f x = (ray * range).cast<float>();
  return {{x.x(), x.y(), x.z(), modelIntensity(sensor_, hit, lasers_[row].gain, random),
           static_cast<float>(timeOf(column)), static_cast<std::int16_t>(row)},
          hit.material.label,
          static_cast<float>(range)};
}

void Simulator::sweep(const Slice& slice, double stamp, std::vector<Return>& returns) const {
  Random random(config_.seed, kDropoutStream, index_);
  const double dropout = random.uniform(description_.dropout.low, description_.dropout.high);
  std::vector<Pose> poses;  // of the slice's columns
  for (std::size_t column = slice.begin; column < slice.end; ++column) {
    if (config_.skewed || poses.empty()) poses.push_back(sensorPose(stamp + timeOf(column)));
  }
  parallelFor(lasers_.size(), config_.threads, [&](std::size_t row) {
    for (std::size_t column = slice.begin; column < slice.end; ++column) {
      const Pose& pose = config_.skewed ? poses[column - slice.begin] : poses.front();
      returns[row * columns_.size() + column] = shoot(pose, row, column, dropout);
    }
  });
}

void Simulator::mixEdges(std::size_t row, std::vector<Return>& returns) const {
  Random random(config_.seed, kEdgeStream - index_, row);
  for (std::size_t column = 1; column < columns_.size(); ++column) {
    const Return& before = returns[row * columns_.size() + column - 1];
    Return& now = returns[row * columns_.size() + column];
    const float step = std::abs(now.range - before.range);
    if (before.range <= 0.0F || now.range <= 0.0F || step < kMinEdge || step > kMaxEdge) continue;
    if (!random.chance(sensor_.edge_mixing)) continue;
    // One pulse on both surfaces: its echo lies between them.
    const auto share = static_cast<float>(random.uniform(0.1, 0.9));
    const float range = now.range + share * (before.range - now.range);
    const float scale = range / now.range;
    now.point.x *= scale;
    now.point.y *= scale;
    now.point.z *= scale;
    if (before.range < now.range) now.label = before.label;
    now.range = range;
  }
}

std::optional<SimulatedScan> Simulator::next() {
  if (index_ == scans_) return std::nullopt;
  const double time = static_cast<double>(index_) / config_.rate;
  std::vector<Return> returns(lasers_.size() * columns_.size());
  for (const Slice& slice : slices(time)) {
    world_.moveTo(slice.time);
    sweep(slice, time, returns);
  }
  for (std::size_t row = 0; row < lasers_.size(); ++row) mixEdges(row, returns);
  SimulatedScan result;
  for (const Return& r : returns) {
    if (r.range <= 0.0F) continue;
    result.scan.points.push_back(r.point);
    result.truth.push_back(r.label);
  }
  result.exact_pose = sensorPose(time);
  result.scan.stamp_ns = std::llround(time * 1e9);
  result.scan.pose = disturbed(result.exact_pose, time);
  ++index_;
  return result;
}

}  // namespace segdf

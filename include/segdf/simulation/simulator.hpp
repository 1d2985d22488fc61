// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/simulation/scene.hpp"
#include "segdf/simulation/sensor_model.hpp"
#include "segdf/simulation/world.hpp"

namespace segdf {

/// One simulated drive.
struct SimulationConfig {
  std::string sensor = "hdl64";
  std::size_t scans = 100;
  double rate = 10.0;  ///< scans a second
  double speed = 8.0;  ///< of the ego vehicle, m/s
  std::uint64_t seed = 1;
  double pose_noise = 0.0;        ///< sigma per axis of Scan::pose, metres
  double pose_noise_angle = 0.0;  ///< sigma per axis, degrees
  int threads = 1;
};

/// A scan with what only a simulator knows.
struct SimulatedScan {
  Scan scan;                         ///< pose with noise
  std::vector<std::uint32_t> truth;  ///< SemanticKITTI label of each point
  Pose exact_pose = Pose::Identity();
};

/// Drives a spinning LiDAR along a street (method.md 8). Each sweep is taken at one instant, as
/// after deskewing. Points are ring-major from the topmost laser, azimuth rising from +x, as in
/// KITTI's files. Everything follows from the configuration: same seed, same bytes, on any number
/// of threads. Cost is linear in the number of rays.
class Simulator {
 public:
  /// @throws std::invalid_argument for an unknown sensor
  explicit Simulator(const SimulationConfig& config);
  /// As above in a scene of one's own.
  Simulator(const SimulationConfig& config, const Scene& scene);

  /// The next scan; nothing after the last.
  std::optional<SimulatedScan> next();

 private:
  struct Return {
    Point point;
    std::uint32_t label = 0;
    bool valid = false;
  };
  /// Constant errors of one laser.
  struct Laser {
    double bias = 0.0;  ///< metres
    double gain = 1.0;
  };

  Pose sensorPose(double time) const;
  Pose disturbed(const Pose& exact) const;
  Return shoot(const Pose& pose, std::size_t row, std::size_t column) const;

  SimulationConfig config_;
  SensorModel sensor_;
  Scene scene_;
  World world_;
  std::vector<Laser> lasers_;
  std::size_t index_ = 0;
};

}  // namespace segdf

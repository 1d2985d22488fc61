// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/simulation/random.hpp"
#include "segdf/simulation/scene.hpp"
#include "segdf/simulation/scene_description.hpp"
#include "segdf/simulation/sensor_model.hpp"
#include "segdf/simulation/world.hpp"

namespace segdf {

/// One simulated drive. What is not set is as the scene says.
struct SimulationConfig {
  std::string scene = "mixed";       ///< a built-in scene's name or a scene file
  std::string sensor;                ///< empty: the scene's, or else hdl64
  std::optional<std::size_t> scans;  ///< fewer or more than the scene's duration holds
  double rate = 10.0;                ///< scans a second
  std::optional<double> speed;       ///< of the ego vehicle, m/s
  std::uint64_t seed = 1;
  std::optional<double> pose_noise;             ///< sigma per axis of Scan::pose, metres
  std::optional<double> pose_noise_angle;       ///< sigma per axis, degrees
  std::optional<double> pose_drift;             ///< error per way driven, percent
  std::optional<SimulatedIntensity> intensity;  ///< instead of the sensor's own
  bool skewed = false;  ///< each point where the sensor was when it was taken, with its time
  int threads = 1;
};

/// A scan with what only a simulator knows.
struct SimulatedScan {
  Scan scan;                         ///< pose with noise
  std::vector<std::uint32_t> truth;  ///< SemanticKITTI label of each point
  Pose exact_pose = Pose::Identity();
};

/// Drives a spinning LiDAR through a scene (method.md 8). A sweep is taken at one instant, as after
/// deskewing, or skewed: over the time between two scans, in slices in which what moves stands
/// still. Points are ring-major from the topmost laser, azimuth rising from +x, as in KITTI's
/// files. Everything follows from the configuration: same seed, same bytes, on any number of
/// threads. Cost is linear in the number of rays.
class Simulator {
 public:
  /// @throws std::invalid_argument for an unknown sensor or scene, or a bad scene file
  explicit Simulator(const SimulationConfig& config);
  /// As above with a scene of one's own. @param scans number of scans
  Simulator(const SimulationConfig& config, const Scene& scene, std::size_t scans);

  /// The next scan; nothing after the last.
  std::optional<SimulatedScan> next();

  std::size_t scans() const { return scans_; }
  const SensorModel& sensor() const { return sensor_; }
  const Scene& scene() const { return scene_; }

 private:
  struct Return {
    Point point;
    std::uint32_t label = 0;
    float range = 0.0F;  ///< metres, 0: none
  };
  /// Constant errors of one laser, and its direction.
  struct Laser {
    double bias = 0.0;  ///< metres
    double gain = 1.0;
    double cos_elevation = 1.0;
    double sin_elevation = 0.0;
  };
  struct Column {
    double cos_azimuth = 1.0;
    double sin_azimuth = 0.0;
  };
  /// Columns [begin, end), taken at one time.
  struct Slice {
    std::size_t begin = 0;
    std::size_t end = 0;
    double time = 0.0;  ///< seconds
  };

  Simulator(const SimulationConfig& config, const SceneDescription& description);
  Simulator(const SimulationConfig& config,
            const SceneDescription& description,
            const Scene& scene,
            std::size_t scans);
  void prepare();
  Pose sensorPose(double time) const;
  Pose disturbed(const Pose& exact, double time) const;
  std::vector<Slice> slices(double time) const;
  double timeOf(std::size_t column) const;
  Eigen::Vector3d direction(std::size_t row, std::size_t column, Random& random) const;
  void sweep(const Slice& slice, double stamp, std::vector<Return>& returns) const;
  Return shoot(const Pose& pose, std::size_t row, std::size_t column, double dropout) const;
  void mixEdges(std::size_t row, std::vector<Return>& returns) const;

  SimulationConfig config_;
  SceneDescription description_;
  SensorModel sensor_;
  Scene scene_;
  std::size_t scans_ = 0;
  World world_;
  std::vector<Laser> lasers_;
  std::vector<Column> columns_;
  std::size_t index_ = 0;
};

}  // namespace segdf

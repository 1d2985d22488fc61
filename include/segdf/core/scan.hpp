// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace segdf {

/// Rigid transform; `a_T_b` takes coordinates of frame b into frame a. Translation in metres.
using Pose = Eigen::Isometry3d;

/// One LiDAR return in the sensor frame (x forward or as the sensor has it, z up).
struct Point {
  float x = 0.0F;          ///< metres
  float y = 0.0F;          ///< metres
  float z = 0.0F;          ///< metres
  float intensity = 0.0F;  ///< in the sensor's own unit (see `intensity.profile`)
  float time = 0.0F;       ///< seconds after the scan's stamp, 0 when unknown
  std::int16_t ring = -1;  ///< index of the laser, -1 when unknown

  Eigen::Vector3f position() const { return {x, y, z}; }
};

/// One sweep P_k of the draft's section III-A with its pose T_k (sensor frame Q_k to map frame M).
struct Scan {
  std::int64_t stamp_ns = 0;     ///< header stamp, nanoseconds
  Pose pose = Pose::Identity();  ///< map_T_sensor
  std::vector<Point> points;     ///< in the sensor frame, in the order in which they came

  double stampSeconds() const { return static_cast<double>(stamp_ns) * 1e-9; }
};

/// True iff all coordinates of the point are finite.
inline bool isFinite(const Point& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

/// True iff the pose is finite and its rotation is orthonormal within 1e-3.
bool isValidPose(const Pose& pose);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"

namespace segdf {

/// One convex part of an object, in the object's frame (x forward, z up from its foot). Metres.
struct Solid {
  enum class Shape : std::uint8_t { kBox, kCylinder };  ///< a cylinder stands upright

  Shape shape = Shape::kBox;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Ones();  ///< a cylinder's diameter is size.x()
  double yaw = 0.0;                                ///< rad
  float reflectance = 0.3F;                        ///< 0 black .. 1 white, above: retro-reflector
  bool glass = false;                              ///< most beams are lost on it
};

/// Where an object is at a time: straight from way point to way point, standing before the first
/// and after the last. Position in the map frame; its height is the ground's.
struct WayPoint {
  double time = 0.0;  ///< seconds
  double x = 0.0;     ///< metres
  double y = 0.0;     ///< metres
  double yaw = 0.0;   ///< rad
};

/// A thing with one identity, standing or moving.
struct SceneObject {
  std::vector<Solid> solids;
  std::vector<WayPoint> path;        ///< one way point: it stands
  std::uint16_t standing_class = 0;  ///< SemanticKITTI class when it never moves
  std::uint16_t moving_class = 0;    ///< SemanticKITTI class when it moves at any time
  std::uint16_t instance = 0;        ///< 0 = none

  bool moves() const { return path.size() > 1; }
  WayPoint at(double time) const;
  /// Truth label of all its points: instance and class.
  std::uint32_t label() const;
};

/// The ground as a height over (x, y), metres: undulating road, kerbs, sidewalks.
struct StreetGround {
  double undulation = 0.15;   ///< amplitude, metres
  double kerb = 0.12;         ///< height of the sidewalk over the road, metres
  double half_road = 7.0;     ///< kerbs stand at y = +-half_road
  double half_street = 11.5;  ///< sidewalks reach to here
  double x_min = -120.0;
  double x_max = 240.0;
  double y_reach = 70.0;

  double heightAt(double x, double y) const;
  /// Road, sidewalk or terrain.
  std::uint16_t classAt(double y) const;
};

/// All that rays can hit, and the way of the sensor over it.
struct Scene {
  StreetGround ground;
  std::vector<SceneObject> objects;
  std::vector<WayPoint> ego;

  /// Pose of an object (or the ego vehicle) standing on the ground at a way point, map_T_object.
  Pose poseAt(const WayPoint& place) const;
};

/// Place on a path at a time.
WayPoint interpolate(const std::vector<WayPoint>& path, double time);

}  // namespace segdf

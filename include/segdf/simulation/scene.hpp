// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"
#include "segdf/simulation/ground.hpp"

namespace segdf {

/// One convex part of an object, in the object's frame (x forward, z up from its foot). Metres.
struct Solid {
  enum class Shape : std::uint8_t {
    kBox,
    kCylinder,  ///< upright; its diameter is size.x(), its height size.z()
    kWheel,     ///< a cylinder whose axis lies across; diameter size.x(), width size.z()
    kLeaf       ///< a flat square, size.x() wide, that leans back by half its height
  };

  Shape shape = Shape::kBox;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  Eigen::Vector2d taper = Eigen::Vector2d::Ones();  ///< size of the top relative to the base
  double yaw = 0.0;                                 ///< rad
  float reflectance = 0.3F;                         ///< 0 black .. 1 white, above: retro-reflector
  bool glass = false;                               ///< most beams are lost in it or go through
};

/// A part that swings about an axis across the object while it moves: legs.
struct Limb {
  std::vector<Solid> solids;  ///< in the object's frame, hanging straight
  double pivot = 1.0;         ///< height of the axis, metres
  double swing = 0.4;         ///< amplitude, rad
  double phase = 0.0;         ///< rad, where the object's way is 0
  double cycle = 1.4;         ///< way of a full swing to and fro, metres
};

/// Where an object is at a time. Position in the map frame; its height is the ground's.
struct WayPoint {
  double time = 0.0;  ///< seconds
  double x = 0.0;     ///< metres
  double y = 0.0;     ///< metres
  double yaw = 0.0;   ///< rad
  double way = 0.0;   ///< metres gone since the first way point
};

/// A thing with one identity, standing or moving.
struct SceneObject {
  std::vector<Solid> solids;
  std::vector<Limb> limbs;
  std::vector<WayPoint> path;        ///< one way point: it stands
  std::uint16_t standing_class = 0;  ///< SemanticKITTI class when it never moves
  std::uint16_t moving_class = 0;    ///< SemanticKITTI class when it moves in sight
  std::uint16_t instance = 0;        ///< 0 = none
  double length = 1.0;               ///< of its footprint along x, metres
  double width = 1.0;                ///< of its footprint along y, metres
  bool upright = false;              ///< does not lean with the ground
  bool moves_in_sight = true;        ///< what moves only where nobody sees it counts as standing

  bool moves() const { return path.size() > 1; }
  WayPoint at(double time) const;
  /// Truth label of all its points: instance and class.
  std::uint32_t label() const;
};

/// All that rays can hit, and the way of the sensor over it.
struct Scene {
  Terrain ground;
  std::vector<SceneObject> objects;
  std::vector<WayPoint> ego;

  /// Pose of an object on the ground at a way point, map_T_object: unless it is upright, the slope
  /// under its footprint tilts it.
  Pose poseAt(const WayPoint& place, double length, double width, bool upright) const;
  Pose poseOf(const SceneObject& object, double time) const;
};

/// Settles moves_in_sight of all objects for a drive: SemanticKITTI labels an object moving when it
/// moves in some scan, so it has to go half a metre or more while it is within 60 m of the ego.
/// @param duration, step seconds; times looked at are 0, step, ... up to the duration
void settleSight(Scene& scene, double duration, double step);

/// Place on a path at a time: straight from way point to way point, standing before the first and
/// after the last.
WayPoint interpolate(const std::vector<WayPoint>& path, double time);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Core>

#include "segdf/simulation/mesh.hpp"
#include "segdf/simulation/scene.hpp"

namespace segdf {

/// What a ray hits first.
struct RayHit {
  double range = 0.0;          ///< metres
  double cos_incidence = 0.0;  ///< of the angle between ray and surface normal, 0..1
  Material material;
};

/// A scene ready to be ray-cast (Embree): what stands is built once, what moves is placed for each
/// scan.
class World {
 public:
  /// @throws std::runtime_error when Embree cannot be started
  explicit World(const Scene& scene);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// Puts every moving object where it is at this time, seconds.
  void moveTo(double time);

  /// First hit along a unit direction within `reach` metres, map frame. Safe to call from several
  /// threads.
  std::optional<RayHit> cast(const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction,
                             double reach) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace segdf {

/// Convex hull of an object seen from above.
class Footprint {
 public:
  /// @param points in the plane, metres, at least one
  explicit Footprint(std::vector<Eigen::Vector2f> points);

  /// True inside the hull and up to the margin outside of it, metres.
  bool contains(const Eigen::Vector2f& place, float margin) const;

  /// Holds every place that the footprint contains with a margin, metres.
  Eigen::AlignedBox2f bounds(float margin) const;

  /// Of the hull, counter-clockwise.
  const std::vector<Eigen::Vector2f>& corners() const { return hull_; }

 private:
  std::vector<Eigen::Vector2f> hull_;  ///< corners, counter-clockwise
  Eigen::AlignedBox2f bounds_;
};

/// What an object takes up: its footprint, from its lowest to its highest point.
struct Volume {
  Footprint footprint;
  float bottom = 0.0F;  ///< metres
  float top = 0.0F;     ///< metres

  /// True inside and up to the margin around it, metres, also over and under it.
  bool contains(const Eigen::Vector3f& place, float margin) const;
};

/// A volume in another frame. @param to_T_from does not tilt by much
Volume transformed(const Volume& volume, const Eigen::Isometry3f& to_T_from);

}  // namespace segdf

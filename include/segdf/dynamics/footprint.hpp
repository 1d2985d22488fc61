// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

namespace segdf {

/// Convex hull of an object seen from above, with a margin around it.
class Footprint {
 public:
  /// @param points in the plane, metres, at least one. @param margin metres
  Footprint(std::vector<Eigen::Vector2f> points, float margin);

  /// True inside the hull and up to the margin outside of it.
  bool contains(const Eigen::Vector2f& place) const;

  /// Holds every place that the footprint contains.
  const Eigen::AlignedBox2f& bounds() const { return bounds_; }

 private:
  std::vector<Eigen::Vector2f> hull_;  ///< corners, counter-clockwise
  float margin_;
  Eigen::AlignedBox2f bounds_;  ///< with the margin
};

}  // namespace segdf

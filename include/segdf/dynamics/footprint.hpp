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

 private:
  std::vector<Eigen::Vector2f> hull_;  ///< corners, counter-clockwise
  Eigen::AlignedBox2f bounds_;
};

}  // namespace segdf

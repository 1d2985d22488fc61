// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "segdf/dynamics/area_index.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// The ground that an object stands on, as a plane through the ground points around it.
class LocalGround {
 public:
  /// Fits the plane to the ground points of the frame within 4 m of the area, the nearer the more.
  /// What sticks out above it, such as feet and wheels that were taken for ground, hardly counts.
  /// Where there is too little ground the height of frame.seg is used instead.
  /// @param places of the frame's points
  LocalGround(const KeyFrame& frame, const AreaIndex& places, const Eigen::AlignedBox2f& area);

  /// Height of point i of the frame, metres.
  float heightOf(std::size_t i) const;

 private:
  void fit(const std::vector<Eigen::Vector3f>& ground, const Eigen::AlignedBox2f& area);

  const KeyFrame& frame_;
  bool known_ = false;
  Eigen::Vector2f center_ = Eigen::Vector2f::Zero();
  Eigen::Vector3f plane_ = Eigen::Vector3f::Zero();  ///< z = a (x - cx) + b (y - cy) + c
};

}  // namespace segdf

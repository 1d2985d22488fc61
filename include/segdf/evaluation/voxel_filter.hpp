// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/evaluation/point_grid.hpp"

namespace segdf {

/// Points with a class each; the two lists are of the same length.
struct ClassedPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint16_t> classes;  ///< whole numbers, never packed into a float

  void add(const Eigen::Vector3f& point, std::uint16_t semantic_class) {
    points.push_back(point);
    classes.push_back(semantic_class);
  }
  void append(const ClassedPoints& other);
};

/// Centroids of the occupied voxels of a grid whose corner is the origin, ordered by x, y, z.
/// @param leaf edge, metres
std::vector<Eigen::Vector3f> voxelCentroids(const std::vector<Eigen::Vector3f>& points,
                                            double leaf);

/// As voxelCentroids; each voxel has the class of the given point nearest to its centroid, which
/// may lie in a neighbouring voxel (peers.md 3.2).
ClassedPoints voxelFilter(const ClassedPoints& cloud, double leaf);

}  // namespace segdf

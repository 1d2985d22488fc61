// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/horizontal_extent.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Where some points lie, seen from above and from the sensor. Metres.
struct ClusterShape {
  std::size_t points = 0;
  Eigen::AlignedBox2f area;
  HorizontalExtent extent;
  float bottom = std::numeric_limits<float>::infinity();     ///< over ground
  float top = -std::numeric_limits<float>::infinity();       ///< over ground
  float nearest = std::numeric_limits<float>::infinity();    ///< horizontal distance
  float farthest = -std::numeric_limits<float>::infinity();  ///< horizontal distance
  std::int32_t column = RangeImage::kNone;  ///< of the first point, from which the next two count
  std::int32_t left = 0;                    ///< not above 0
  std::int32_t right = 0;                   ///< not below 0

  void add(const Point& point, float height, std::int32_t at_column, std::int32_t columns);
};

/// From one column of an image to another the shorter way round.
std::int32_t columnsBetween(std::int32_t from, std::int32_t to, std::int32_t columns);

/// True when what has such an extent is no longer and no wider than a vehicle (`config.length`,
/// `config.width`).
bool fitsVehicle(const HorizontalExtent& extent, const VehicleConfig& config);

/// Shapes of the clusters that fit a vehicle; the others have 0 points. Linear in points.
/// @param height of each point over the local ground, metres
std::vector<ClusterShape> shapesOf(const std::vector<Point>& points,
                                   const RangeImage& image,
                                   const std::vector<float>& height,
                                   const VehicleConfig& config,
                                   const CurvedVoxels& voxels,
                                   const Clusters& clusters);

/// True when a vehicle may have such a shape.
bool mayBeVehicle(const ClusterShape& shape, const VehicleConfig& config);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/cluster_shape.hpp"

#include <algorithm>
#include <cmath>

namespace segdf {

namespace {

/// Which clusters need no closer look: of what is longer along an axis than the diagonal of a
/// vehicle, one point of each voxel tells.
std::vector<std::uint8_t> findLarge(const std::vector<Point>& points,
                                    const VehicleConfig& config,
                                    const CurvedVoxels& voxels,
                                    const Clusters& clusters) {
  std::vector<Eigen::AlignedBox2f> areas(clusters.count);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (clusters.of_voxel[v] == Clusters::kNoise) continue;
    const Point& p = points[voxels.points[voxels.begin[v]]];
    areas[static_cast<std::size_t>(clusters.of_voxel[v])].extend(Eigen::Vector2f(p.x, p.y));
  }
  const auto longest = static_cast<float>(std::hypot(config.length, config.width));
  std::vector<std::uint8_t> large(clusters.count, 0);
  for (std::size_t c = 0; c < large.size(); ++c) {
    if (!areas[c].isEmpty() && areas[c].sizes().maxCoeff() > longest) large[c] = 1;
  }
  return large;
}

}  // namespace

bool fitsVehicle(const HorizontalExtent& extent, const VehicleConfig& config) {
  return static_cast<double>(extent.length()) <= config.length &&
         static_cast<double>(extent.width()) <= config.width;
}

std::int32_t columnsBetween(std::int32_t from, std::int32_t to, std::int32_t columns) {
  std::int32_t way = to - from;
  if (way >= columns / 2) way -= columns;
  if (way < -(columns / 2)) way += columns;
  return way;
}

void ClusterShape::add(const Point& point,
                       float height,
                       std::int32_t at_column,
                       std::int32_t columns) {
  if (points++ == 0) column = at_column;
  const std::int32_t way = columnsBetween(column, at_column, columns);
  left = std::min(left, way);
  right = std::max(right, way);
  bottom = std::min(bottom, height);
  top = std::max(top, height);
  area.extend(Eigen::Vector2f(point.x, point.y));
  extent.add(point.x, point.y);
  const float distance = std::sqrt(point.x * point.x + point.y * point.y);
  nearest = std::min(nearest, distance);
  farthest = std::max(farthest, distance);
}

std::vector<ClusterShape> shapesOf(const std::vector<Point>& points,
                                   const RangeImage& image,
                                   const std::vector<float>& height,
                                   const VehicleConfig& config,
                                   const CurvedVoxels& voxels,
                                   const Clusters& clusters) {
  const std::vector<std::uint8_t> large = findLarge(points, config, voxels, clusters);
  std::vector<ClusterShape> shapes(clusters.count);
  forEachMember(voxels, clusters, [&](std::size_t cluster, std::uint32_t i) {
    if (large[cluster] != 0) return;
    shapes[cluster].add(points[i], height[i], image.columnOf(i), image.columns());
  });
  for (ClusterShape& shape : shapes) {
    if (shape.points > 0 && !fitsVehicle(shape.extent, config)) shape = {};
  }
  return shapes;
}

bool mayBeVehicle(const ClusterShape& shape, const VehicleConfig& config) {
  const auto top = static_cast<double>(shape.top);
  return shape.points > 0 && top >= config.top_min && top <= config.top_max;
}

}  // namespace segdf

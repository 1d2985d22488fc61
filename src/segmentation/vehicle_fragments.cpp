// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/vehicle_fragments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace segdf {

namespace {

// What is nearer than the vehicle's face by more is in front of it, metres.
constexpr float kBefore = 0.3F;
// Fragments end at most this far over its top, or at the roof of a car of which the rest has only
// the bonnet, and begin this far over ground, metres.
constexpr float kAbove = 0.2F;
constexpr float kCarRoof = 1.6F;
constexpr float kOverGround = 0.1F;
// Over what is lower than the roofs of cars its own roof may be seen, metres; over others only
// noise so near to its footprint.
constexpr float kLowestRoof = 1.4F;
constexpr float kWithin = 0.5F;
// Columns beside that count as the same, for sensors with fewer than the image.
constexpr int kColumns = 3;

class Fragments {
 public:
  /// @param cluster of each point
  Fragments(const RangeImage& image,
            const std::vector<std::int32_t>& cluster,
            const VehicleConfig& config,
            const std::vector<ClusterShape>& shapes)
      : image_(image),
        cluster_(cluster),
        config_(config),
        shapes_(shapes),
        columns_(image.columns()),
        beside_(static_cast<std::int32_t>(std::lround(config.beside / 360.0 * image.columns()))) {
    for (std::size_t c = 0; c < shapes.size(); ++c) {
      if (mayBeVehicle(shapes[c], config)) vehicles_.push_back(c);
    }
  }

  /// The vehicle that noise belongs to, kNoise when to none.
  /// @param point one of the noise
  std::int32_t ownerOfNoise(const ClusterShape& noise, const Point& p, std::uint32_t point) const {
    if (noise.bottom < kOverGround) return Clusters::kNoise;
    const std::int32_t vehicle = owner(noise, [](const ClusterShape&) { return true; });
    if (vehicle == Clusters::kNoise) return vehicle;
    const ClusterShape& shape = shapes_[static_cast<std::size_t>(vehicle)];
    const bool near = shape.top < kLowestRoof || shape.extent.contains(p.x, p.y, kWithin);
    return near || !isOver(point, vehicle) ? vehicle : Clusters::kNoise;
  }

  /// The vehicle that a cluster belongs to, kNoise when to none but itself.
  std::int32_t ownerOfCluster(const ClusterShape& cluster) const {
    if (cluster.points == 0 ||
        static_cast<double>(cluster.top - cluster.bottom) > config_.fragment_height) {
      return Clusters::kNoise;
    }
    return owner(cluster, [&](const ClusterShape& vehicle) {
      return static_cast<double>(cluster.points) <=
             config_.fragment * static_cast<double>(vehicle.points);
    });
  }

 private:
  /// True where the vehicle is seen below in the image and not above.
  bool isOver(std::uint32_t point, std::int32_t vehicle) const {
    const int row = image_.rowOf(point);
    return !isSeen(0, row, point, vehicle) && isSeen(row + 1, image_.rows(), point, vehicle);
  }

  /// True when the vehicle has points in some rows of a point's column or beside it.
  bool isSeen(int first, int last, std::uint32_t point, std::int32_t vehicle) const {
    for (int row = first; row < last; ++row) {
      for (int right = -kColumns; right <= kColumns; ++right) {
        const std::int32_t i = image_.at(row, image_.columnOf(point) + right);
        if (i != RangeImage::kNone && cluster_[static_cast<std::size_t>(i)] == vehicle) return true;
      }
    }
    return false;
  }

  template <class Condition>
  std::int32_t owner(const ClusterShape& fragment, const Condition& may_own) const {
    std::int32_t nearest = Clusters::kNoise;
    float distance = std::numeric_limits<float>::infinity();
    for (std::size_t c : vehicles_) {
      const ClusterShape& vehicle = shapes_[c];
      if (!may_own(vehicle) || !hides(vehicle, fragment) || !fitTogether(vehicle, fragment))
        continue;
      const float away = vehicle.area.exteriorDistance(fragment.area);
      if (away >= distance) continue;
      distance = away;
      nearest = static_cast<std::int32_t>(c);
    }
    return nearest;
  }

  bool hides(const ClusterShape& vehicle, const ClusterShape& fragment) const {
    if (fragment.nearest < vehicle.nearest - kBefore) return false;
    if (fragment.farthest > vehicle.farthest + static_cast<float>(config_.behind)) return false;
    if (fragment.top > std::max(vehicle.top + kAbove, kCarRoof)) return false;
    const std::int32_t way = columnsBetween(vehicle.column, fragment.column, columns_);
    return way + fragment.left >= vehicle.left - beside_ &&
           way + fragment.right <= vehicle.right + beside_;
  }

  bool fitTogether(const ClusterShape& vehicle, const ClusterShape& fragment) const {
    HorizontalExtent both = vehicle.extent;
    both.add(fragment.extent);
    return fitsVehicle(both, config_);
  }

  const RangeImage& image_;
  const std::vector<std::int32_t>& cluster_;
  const VehicleConfig& config_;
  const std::vector<ClusterShape>& shapes_;
  std::int32_t columns_;
  std::int32_t beside_;  ///< columns
  std::vector<std::size_t> vehicles_;
};

}  // namespace

void joinFragments(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const VehicleConfig& config,
                   const CurvedVoxels& voxels,
                   const std::vector<ClusterShape>& shapes,
                   Clusters& clusters) {
  const std::vector<std::int32_t> before = clusterOfPoints(points.size(), voxels, clusters);
  const Fragments fragments(image, before, config, shapes);
  std::vector<std::int32_t> owner(shapes.size());
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    owner[c] = fragments.ownerOfCluster(shapes[c]);
    if (owner[c] == Clusters::kNoise) owner[c] = static_cast<std::int32_t>(c);
  }
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    std::int32_t& cluster = clusters.of_voxel[v];
    if (cluster != Clusters::kNoise) {
      cluster = owner[static_cast<std::size_t>(cluster)];
      continue;
    }
    const std::uint32_t first = voxels.points[voxels.begin[v]];
    ClusterShape noise;
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      const std::uint32_t i = voxels.points[k];
      noise.add(points[i], height[i], image.columnOf(i), image.columns());
    }
    cluster = fragments.ownerOfNoise(noise, points[first], first);
  }
}

}  // namespace segdf

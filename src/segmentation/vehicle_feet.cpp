// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/vehicle_feet.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "segdf/segmentation/ground_cells.hpp"
#include "segdf/segmentation/voxel_edit.hpp"

namespace segdf {

namespace {

constexpr float kReach = 2.0F;  // metres around a vehicle
constexpr double kDeepShare = 0.01;
constexpr float kMargin = 0.1F;  // of a footprint, metres

Eigen::AlignedBox2f grown(Eigen::AlignedBox2f area, float by) {
  area.min().array() -= by;
  area.max().array() += by;
  return area;
}

/// A cluster and the plane that it may stand on.
struct Standing {
  std::optional<GroundPlane> plane;
  std::size_t points = 0;          ///< of the cluster
  std::size_t deep = 0;            ///< deeper than a foot
  std::vector<std::uint32_t> low;  ///< those that may be ground
};

class Feet {
 public:
  Feet(const std::vector<Point>& points,
       const VehicleConfig& config,
       const std::vector<ClusterShape>& shapes,
       const std::vector<PointRole>& roles)
      : points_(points),
        config_(config),
        shapes_(shapes),
        standing_(shapes.size()),
        cells_(areasAround(shapes, config, kReach), areasAround(shapes, config, kMargin)) {
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (roles[i] == PointRole::kGround) cells_.add(points[i], i);
    }
    for (std::size_t c = 0; c < shapes.size(); ++c) {
      if (mayBeVehicle(shapes[c], config)) {
        standing_[c].plane = planeAround(points, cells_, grown(shapes[c].area, kReach),
                                         grown(shapes[c].area, kMargin));
      }
    }
  }

  void count(std::size_t cluster, std::uint32_t point) {
    Standing& standing = standing_[cluster];
    if (!standing.plane) return;
    const double height = standing.plane->heightOf(points_[point]);
    ++standing.points;
    if (height < config_.foot) standing.low.push_back(point);
    if (height < -config_.foot_depth) ++standing.deep;
  }

  /// Calls visit(point) for the points of clusters that are ground; when all points are counted.
  template <class Visit>
  void forEachGround(const Visit& visit) const {
    for (std::size_t c = 0; c < standing_.size(); ++c) {
      if (!stands(c)) continue;
      for (std::uint32_t i : standing_[c].low) visit(i);
    }
  }

  /// Calls visit(cluster, point) for the ground points that belong to a cluster; likewise.
  template <class Visit>
  void forEachFoot(const Visit& visit) const {
    for (std::size_t c = 0; c < shapes_.size(); ++c) {
      if (!stands(c)) continue;
      cells_.forEachCell(grown(shapes_[c].area, kMargin), [&](const GroundCell& cell) {
        for (std::uint32_t i : cell.points) {
          if (isFoot(c, i)) visit(c, i);
        }
      });
    }
  }

 private:
  static std::vector<Eigen::AlignedBox2f> areasAround(const std::vector<ClusterShape>& shapes,
                                                      const VehicleConfig& config,
                                                      float by) {
    std::vector<Eigen::AlignedBox2f> areas;
    for (const ClusterShape& shape : shapes) {
      if (mayBeVehicle(shape, config)) areas.push_back(grown(shape.area, by));
    }
    return areas;
  }

  /// A cluster that has no points any more stands nowhere.
  bool stands(std::size_t cluster) const {
    const Standing& s = standing_[cluster];
    const auto all = static_cast<double>(s.points);
    return s.points > 0 && static_cast<double>(s.low.size()) <= config_.foot_share * all &&
           static_cast<double>(s.deep) <= kDeepShare * all;
  }

  bool isFoot(std::size_t cluster, std::uint32_t point) const {
    const Point& p = points_[point];
    return standing_[cluster].plane->heightOf(p) > config_.foot_rise &&
           shapes_[cluster].extent.contains(p.x, p.y, kMargin);
  }

  const std::vector<Point>& points_;
  const VehicleConfig& config_;
  const std::vector<ClusterShape>& shapes_;
  std::vector<Standing> standing_;
  GroundCells cells_;
};

}  // namespace

void settleFeet(const std::vector<Point>& points,
                const VehicleConfig& config,
                const CurvedGrid& grid,
                const std::vector<ClusterShape>& shapes,
                std::vector<PointRole>& roles,
                CurvedVoxels& voxels,
                Clusters& clusters) {
  Feet feet(points, config, shapes, roles);
  forEachMember(voxels, clusters,
                [&](std::size_t cluster, std::uint32_t i) { feet.count(cluster, i); });
  std::vector<AddedPoint> found;
  feet.forEachFoot([&](std::size_t cluster, std::uint32_t i) {
    if (roles[i] != PointRole::kGround) return;
    roles[i] = PointRole::kObject;
    found.push_back({i, static_cast<std::int32_t>(cluster)});
  });
  feet.forEachGround([&](std::uint32_t i) { roles[i] = PointRole::kGround; });
  editVoxels(points, roles, grid, found, voxels, clusters);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/vehicle_feet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Dense>

#include "segdf/segmentation/moments.hpp"

namespace segdf {

namespace {

constexpr float kReach = 2.0F;        // metres around a vehicle
constexpr double kMinPoints = 20.0;   // for a plane
constexpr double kDeepShare = 0.01;
// Square metres that hold the plane level where the ground is seen on one side only.
constexpr double kFlatness = 0.2;

/// Level of the ground as a plane.
struct GroundPlane {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double level = 0.0;  ///< at the centre, metres

  float heightOf(const Point& p) const {
    const Eigen::Vector2d way = Eigen::Vector2d(p.x, p.y) - center;
    return static_cast<float>(static_cast<double>(p.z) - level - slope.dot(way));
  }
};

/// Moments of the ground points in square cells of 1 m, of those that are asked for.
class GroundCells {
 public:
  /// @param areas to be asked for
  explicit GroundCells(const std::vector<Eigen::AlignedBox2f>& areas) {
    for (const Eigen::AlignedBox2f& area : areas) all_.extend(area);
    if (all_.isEmpty()) return;
    rows_ = cell(all_.max().x(), all_.min().x()) + 1;
    columns_ = cell(all_.max().y(), all_.min().y()) + 1;
    slot_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), kUnused);
    for (const Eigen::AlignedBox2f& area : areas) {
      forEachSlot(area, [this](std::int32_t& slot) {
        if (slot == kUnused) slot = used_++;
      });
    }
    moments_.resize(static_cast<std::size_t>(used_));
  }

  void add(const Point& p) {
    if (!all_.contains(Eigen::Vector2f(p.x, p.y))) return;
    const std::int32_t slot = slot_[index(cell(p.x, all_.min().x()), cell(p.y, all_.min().y()))];
    if (slot == kUnused) return;
    moments_[static_cast<std::size_t>(slot)].add(static_cast<double>(p.x), static_cast<double>(p.y),
                                                 static_cast<double>(p.z));
  }

  /// Through the ground in the cells of one of the areas; none where there is too little.
  std::optional<GroundPlane> planeIn(const Eigen::AlignedBox2f& area) {
    Moments sum;
    forEachSlot(area, [&](std::int32_t& slot) {
      sum.add(moments_[static_cast<std::size_t>(slot)]);
    });
    if (sum.count < kMinPoints) return std::nullopt;
    const Eigen::Vector3d mean = sum.mean();
    const Eigen::Matrix3d covariance = sum.covariance();
    const Eigen::Matrix2d spread =
        covariance.topLeftCorner<2, 2>() + kFlatness * Eigen::Matrix2d::Identity();
    return GroundPlane{mean.head<2>(), spread.inverse() * covariance.topRightCorner<2, 1>(),
                       mean.z()};
  }

 private:
  static constexpr std::int32_t kUnused = -1;

  static int cell(float at, float least) { return static_cast<int>(at - least); }

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  template <class Visit>
  void forEachSlot(const Eigen::AlignedBox2f& area, const Visit& visit) {
    const Eigen::Vector2f least = all_.min();
    for (int row = cell(area.min().x(), least.x()); row <= cell(area.max().x(), least.x()); ++row) {
      for (int column = cell(area.min().y(), least.y());
           column <= cell(area.max().y(), least.y()); ++column) {
        visit(slot_[index(row, column)]);
      }
    }
  }

  Eigen::AlignedBox2f all_;
  int rows_ = 0;
  int columns_ = 0;
  std::int32_t used_ = 0;
  std::vector<std::int32_t> slot_;
  std::vector<Moments> moments_;
};

/// What lies low of a cluster over its plane.
struct LowPart {
  std::optional<GroundPlane> plane;
  std::size_t points = 0;  ///< of the cluster
  std::size_t low = 0;
  std::size_t deep = 0;
};

class Feet {
 public:
  Feet(const std::vector<Point>& points,
       const VehicleConfig& config,
       const std::vector<ClusterShape>& shapes,
       const std::vector<PointRole>& roles)
      : points_(points), config_(config), parts_(shapes.size()) {
    std::vector<Eigen::AlignedBox2f> areas;
    std::vector<std::size_t> vehicles;
    for (std::size_t c = 0; c < shapes.size(); ++c) {
      if (!mayBeVehicle(shapes[c], config)) continue;
      vehicles.push_back(c);
      areas.push_back(shapes[c].area);
      areas.back().min().array() -= kReach;
      areas.back().max().array() += kReach;
    }
    GroundCells cells(areas);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (roles[i] == PointRole::kGround) cells.add(points[i]);
    }
    for (std::size_t k = 0; k < areas.size(); ++k) {
      parts_[vehicles[k]].plane = cells.planeIn(areas[k]);
    }
  }

  void count(std::size_t cluster, std::uint32_t point) {
    LowPart& part = parts_[cluster];
    if (!part.plane) return;
    const auto height = static_cast<double>(part.plane->heightOf(points_[point]));
    ++part.points;
    if (height < config_.foot) ++part.low;
    if (height < -config_.foot_depth) ++part.deep;
  }

  /// Asked when all points are counted.
  bool isGround(std::size_t cluster, std::uint32_t point) const {
    const LowPart& part = parts_[cluster];
    const auto all = static_cast<double>(part.points);
    return part.low > 0 && static_cast<double>(part.low) <= config_.foot_share * all &&
           static_cast<double>(part.deep) <= kDeepShare * all &&
           static_cast<double>(part.plane->heightOf(points_[point])) < config_.foot;
  }

 private:
  const std::vector<Point>& points_;
  const VehicleConfig& config_;
  std::vector<LowPart> parts_;
};

/// Takes the points that are ground now out of the voxels, and voxels without points away.
void dropGround(const std::vector<PointRole>& roles, CurvedVoxels& voxels, Clusters& clusters) {
  std::size_t kept = 0;
  std::uint32_t end = 0;
  std::uint32_t first = 0;
  for (std::size_t v = 0; v < clusters.of_voxel.size(); ++v) {
    const std::uint32_t last = voxels.begin[v + 1];
    const std::uint32_t begin = end;
    for (std::uint32_t k = first; k < last; ++k) {
      if (roles[voxels.points[k]] != PointRole::kGround) voxels.points[end++] = voxels.points[k];
    }
    first = last;
    if (end == begin) continue;
    voxels.keys[kept] = voxels.keys[v];
    voxels.mean[kept] = voxels.mean[v];
    voxels.deviation[kept] = voxels.deviation[v];
    clusters.of_voxel[kept] = clusters.of_voxel[v];
    voxels.begin[++kept] = end;
  }
  voxels.keys.resize(kept);
  voxels.mean.resize(kept);
  voxels.deviation.resize(kept);
  clusters.of_voxel.resize(kept);
  voxels.begin.resize(kept + 1);
  voxels.points.resize(end);
}

}  // namespace

void releaseGroundUnder(const std::vector<Point>& points,
                        const VehicleConfig& config,
                        const std::vector<ClusterShape>& shapes,
                        std::vector<PointRole>& roles,
                        CurvedVoxels& voxels,
                        Clusters& clusters) {
  Feet feet(points, config, shapes, roles);
  forEachMember(voxels, clusters,
                [&](std::size_t cluster, std::uint32_t i) { feet.count(cluster, i); });
  forEachMember(voxels, clusters, [&](std::size_t cluster, std::uint32_t i) {
    if (feet.isGround(cluster, i)) roles[i] = PointRole::kGround;
  });
  dropGround(roles, voxels, clusters);
}

}  // namespace segdf

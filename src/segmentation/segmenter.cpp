// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/segmenter.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "segdf/core/parallel.hpp"
#include "segdf/core/stage_timer.hpp"
#include "segdf/segmentation/carving.hpp"
#include "segdf/segmentation/cluster_shape.hpp"
#include "segdf/segmentation/ground.hpp"
#include "segdf/segmentation/intensity.hpp"
#include "segdf/segmentation/line_roughness.hpp"
#include "segdf/segmentation/object_feet.hpp"
#include "segdf/segmentation/vehicle_feet.hpp"
#include "segdf/segmentation/vehicle_fragments.hpp"

namespace segdf {

namespace {

constexpr std::size_t kGrain = 4096;

bool isOnVehicle(const Point& p, const InputConfig& config) {
  const auto& box = config.ego_box;
  const auto x = static_cast<double>(p.x);
  const auto y = static_cast<double>(p.y);
  return x > box[0] && x < box[1] && y > box[2] && y < box[3];
}

/// Ground, with feet and wheels given back to what stands on them, and heights over it.
void markGround(const Scan& scan,
                const RangeImage& image,
                const Config& config,
                int threads,
                Segmentation& seg) {
  Ground ground = extractGround(scan.points, seg.roles, image.turns(), config.ground,
                                config.range_image, threads);
  for (std::size_t i = 0; i < seg.roles.size(); ++i) {
    if (ground.is_ground[i] != 0) seg.roles[i] = PointRole::kGround;
  }
  releaseStanding(scan.points, image, config.ground, threads, seg.roles);
  for (std::size_t i = 0; i < seg.roles.size(); ++i) {
    if (seg.roles[i] != PointRole::kGround) ground.is_ground[i] = 0;
  }
  seg.height = heightOverGround(scan.points, ground, config.ground.l_max);
  releaseTouching(scan.points, image, seg.height, config.ground, threads, seg.roles);
}

void describeSurfaces(const Scan& scan,
                      const RangeImage& image,
                      const Config& config,
                      int threads,
                      Segmentation& seg) {
  seg.surfaces = estimateSurfaces(scan.points, seg.roles, image, config.range_image, threads);
  seg.row.resize(scan.points.size());
  seg.column.resize(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    seg.row[i] = image.rowOf(i);
    seg.column[i] = image.columnOf(i);
  }
}

/// Keys of the object points, in the order of the points.
std::vector<KeyedPoint> objectKeys(const Scan& scan,
                                   const std::vector<PointRole>& roles,
                                   const std::vector<double>& turns,
                                   const CurvedGrid& grid,
                                   int threads) {
  std::vector<CurvedGrid::Key> keys(scan.points.size(), 0);
  parallelBlocks(scan.points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (roles[i] != PointRole::kObject) continue;
      keys[i] = grid.keyOf(scan.points[i].position().cast<double>(), turns[i]).value_or(0);
    }
  });
  std::vector<KeyedPoint> items;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i] != 0) items.emplace_back(keys[i], static_cast<std::uint32_t>(i));
  }
  return items;
}

/// Visiting points in the order of the scan leaves the indices of each segment sorted.
std::vector<Segment> collectSegments(const Scan& scan,
                                     const std::vector<std::int32_t>& of_point,
                                     std::size_t clusters) {
  std::vector<std::size_t> sizes(clusters, 0);
  for (std::int32_t cluster : of_point) {
    if (cluster != Clusters::kNoise) ++sizes[static_cast<std::size_t>(cluster)];
  }
  std::vector<Segment> segments(clusters);
  for (std::size_t s = 0; s < segments.size(); ++s) segments[s].points.reserve(sizes[s]);
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    if (of_point[i] == Clusters::kNoise) continue;
    Segment& segment = segments[static_cast<std::size_t>(of_point[i])];
    segment.points.push_back(static_cast<std::uint32_t>(i));
    segment.bounds.extend(scan.points[i].position());
  }
  return segments;
}

}  // namespace

std::vector<PointRole> selectPoints(const std::vector<Point>& points, const InputConfig& config) {
  std::vector<PointRole> roles(points.size(), PointRole::kUnused);
  const auto near = static_cast<float>(config.min_range);
  const auto far = static_cast<float>(config.max_range);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float range = points[i].position().norm();
    // A NaN coordinate makes the range NaN, which is in no interval.
    if (range > near && range < far && !isOnVehicle(points[i], config))
      roles[i] = PointRole::kObject;
  }
  return roles;
}

void completeVehicles(const Scan& scan,
                      const RangeImage& image,
                      const Config& config,
                      const CurvedGrid& grid,
                      Segmentation& seg) {
  if (config.vehicle.length <= 0.0) return;
  const std::vector<ClusterShape> shapes =
      shapesOf(scan.points, image, seg.height, config.vehicle, seg.voxels, seg.clusters);
  joinFragments(scan.points, image, seg.height, config.vehicle, seg.voxels, shapes, seg.clusters);
  settleFeet(scan.points, config.vehicle, grid, shapes, seg.roles, seg.voxels, seg.clusters);
  dropSmallClusters(seg.voxels, static_cast<std::uint32_t>(config.cvi.n_noise), seg.clusters);
}

Segmentation segmentScan(const Scan& scan, const Config& config, int threads, StageTimes& times) {
  Segmentation seg;
  seg.roles = selectPoints(scan.points, config.input);
  seg.non_finite_points = static_cast<std::size_t>(std::count_if(
      scan.points.begin(), scan.points.end(), [](const Point& p) { return !isFinite(p); }));
  std::optional<RangeImage> image;
  {
    const StageTimer timer(times.ground);
    image.emplace(scan.points, seg.roles, config.range_image);
    markGround(scan, *image, config, threads, seg);
  }
  {
    const StageTimer timer(times.normals);
    describeSurfaces(scan, *image, config, threads, seg);
  }
  const StageTimer timer(times.clustering);
  const std::vector<float> intensity =
      calibrateIntensity(scan.points, seg.surfaces, config.intensity);
  const CurvedGrid grid(config.cvi, config.input.min_range);
  seg.voxels =
      buildCurvedVoxels(objectKeys(scan, seg.roles, image->turns(), grid, threads), intensity);
  seg.clusters = clusterVoxels(scan.points, intensity, seg.voxels, grid, config.cvi);
  carveClusters(scan.points, *image, seg.height, config, seg.voxels, seg.clusters);
  completeVehicles(scan, *image, config, grid, seg);
  const std::vector<std::int32_t> of_point =
      clusterOfPoints(scan.points.size(), seg.voxels, seg.clusters);
  measureRoughness(scan.points, *image, of_point, threads, seg.surfaces);
  seg.segments = collectSegments(scan, of_point, seg.clusters.count);
  return seg;
}

}  // namespace segdf

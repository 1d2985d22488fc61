// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/association.hpp"

#include <algorithm>
#include <utility>

#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

/// What lies in the 27 cells around one voxel of the other scan's grid.
struct Surroundings {
  bool occupied = false;
  std::vector<std::int32_t> segments;  ///< ascending, unique
};

/// One point of a segment, to be sorted by cell.
struct MovedPoint {
  CurvedGrid::Key key = 0;
  std::uint32_t segment = 0;
  std::uint32_t point = 0;
};

std::vector<MovedPoint> movePoints(const KeyFrame& from,
                                   const PointsBySegment& points,
                                   const Pose& to_T_from,
                                   const CurvedGrid& grid,
                                   int threads) {
  std::vector<MovedPoint> moved(points.points.size());
  parallelFor(points.begin.size() - 1, threads, [&](std::size_t s) {
    for (std::uint32_t k = points.begin[s]; k < points.begin[s + 1]; ++k) {
      const std::uint32_t i = points.points[k];
      const Eigen::Vector3d x = to_T_from * from.scan.points[i].position().cast<double>();
      // A point too near to the other sensor has no cell there; key 0 is in nobody's neighbourhood.
      moved[k] = {grid.keyOf(x).value_or(0), static_cast<std::uint32_t>(s), i};
    }
  });
  return moved;
}

/// Order of `points` by cell, then segment, then point.
std::vector<std::uint32_t> orderByCell(const std::vector<MovedPoint>& points) {
  std::vector<KeyedPoint> items;
  items.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    items.emplace_back(points[k].key, static_cast<std::uint32_t>(k));
  }
  sortByKey(items);  // stable, and `points` is ordered by segment and point already
  std::vector<std::uint32_t> order;
  order.reserve(items.size());
  for (const KeyedPoint& item : items) order.push_back(item.second);
  return order;
}

std::vector<Surroundings> lookAround(const std::vector<CurvedGrid::Key>& keys,
                                     const KeyFrame& to,
                                     const CurvedGrid& grid) {
  std::vector<Surroundings> around(keys.size());
  forEachNeighbour(keys, to.seg.voxels, grid, 1, [&](std::size_t q, std::size_t v) {
    around[q].occupied = true;
    const std::int32_t segment = to.seg.clusters.of_voxel[v];
    if (segment == Clusters::kNoise) return;
    auto& segments = around[q].segments;
    const auto place = std::lower_bound(segments.begin(), segments.end(), segment);
    if (place == segments.end() || *place != segment) segments.insert(place, segment);
  });
  return around;
}

void countVoxel(const Surroundings& around, SegmentOverlap& overlap) {
  ++overlap.voxels;
  if (around.occupied) ++overlap.occupied;
  for (std::int32_t segment : around.segments) {
    const auto place = std::lower_bound(
        overlap.neighbours.begin(), overlap.neighbours.end(), segment,
        [](const Neighbour& neighbour, std::int32_t value) { return neighbour.segment < value; });
    if (place != overlap.neighbours.end() && place->segment == segment) {
      ++place->voxels;
    } else {
      overlap.neighbours.insert(place, {segment, 1});
    }
  }
}

}  // namespace

double SegmentOverlap::occupancy() const {
  return voxels == 0 ? 1.0 : static_cast<double>(occupied) / static_cast<double>(voxels);
}

double SegmentOverlap::overlap(const Neighbour& neighbour) const {
  return voxels == 0 ? 0.0 : static_cast<double>(neighbour.voxels) / static_cast<double>(voxels);
}

PointsBySegment pointsOfSegments(const KeyFrame& frame) {
  PointsBySegment result{{0}, {}};
  for (const Segment& segment : frame.seg.segments) {
    result.points.insert(result.points.end(), segment.points.begin(), segment.points.end());
    result.begin.push_back(static_cast<std::uint32_t>(result.points.size()));
  }
  return result;
}

std::vector<SegmentOverlap> overlapSegments(const KeyFrame& from,
                                            const PointsBySegment& from_points,
                                            const KeyFrame& to,
                                            const CurvedGrid& grid,
                                            int threads) {
  const Pose to_T_from = to.scan.pose.inverse() * from.scan.pose;
  const std::vector<MovedPoint> points = movePoints(from, from_points, to_T_from, grid, threads);
  const std::vector<std::uint32_t> order = orderByCell(points);
  std::vector<CurvedGrid::Key> keys;
  for (std::uint32_t k : order) {
    if (keys.empty() || keys.back() != points[k].key) keys.push_back(points[k].key);
  }
  const std::vector<Surroundings> around = lookAround(keys, to, grid);

  std::vector<SegmentOverlap> overlaps(from_points.begin.size() - 1);
  std::size_t cell = 0;
  const MovedPoint* previous = nullptr;
  for (std::uint32_t k : order) {
    const MovedPoint& p = points[k];
    if (previous != nullptr && p.key != previous->key) ++cell;
    SegmentOverlap& overlap = overlaps[p.segment];
    const bool first =
        previous == nullptr || p.key != previous->key || p.segment != previous->segment;
    if (first) countVoxel(around[cell], overlap);
    if (!around[cell].occupied) overlap.lost.push_back(p.point);
    previous = &p;
  }
  for (SegmentOverlap& overlap : overlaps) std::sort(overlap.lost.begin(), overlap.lost.end());
  return overlaps;
}

}  // namespace segdf

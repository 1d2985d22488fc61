// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// A segment of the other scan that lies in the neighbourhood.
struct Neighbour {
  std::int32_t segment = 0;  ///< in the other frame
  std::uint32_t voxels = 0;  ///< own voxels that have one of its voxels among their 27
};

/// One segment's voxels seen in the grid of another scan (Algorithm 2, lines 3-8; method.md 6.2).
struct SegmentOverlap {
  std::uint32_t voxels = 0;           ///< |V(C)|
  std::uint32_t occupied = 0;         ///< those with anything among their 27
  std::vector<Neighbour> neighbours;  ///< Neigh(C), ascending by segment
  std::vector<std::uint32_t> lost;    ///< points in voxels with nothing around, ascending

  /// O(C): share of the voxels that are found again; 1 for a segment without voxels.
  double occupancy() const;
  /// a(C, D): share of the voxels that touch segment D.
  double overlap(const Neighbour& neighbour) const;
};

/// Indices into a scan by segment: points[begin[s]] .. points[begin[s + 1] - 1] stand for segment
/// s.
struct PointsBySegment {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> points;
};

/// All points of every segment.
PointsBySegment pointsOfSegments(const KeyFrame& frame);

/// Moves the points that stand for the segments of `from` into the sensor frame of `to`
/// (X = T_to^-1 T_from), puts them into its curved grid and looks at the 27 cells around each
/// voxel. One entry per segment of `from`.
std::vector<SegmentOverlap> overlapSegments(const KeyFrame& from,
                                            const PointsBySegment& points,
                                            const KeyFrame& to,
                                            const CurvedGrid& grid,
                                            int threads);

}  // namespace segdf

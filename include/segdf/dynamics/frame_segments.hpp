// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/footprint.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Box and features of one segment from its points.
void describe(KeyFrame& frame, Segment& segment);

/// Box, features and class of every segment.
void describeAndClassify(KeyFrame& frame, const ClassConfig& config, int threads);

/// Centre of a segment's box, map frame, metres.
Eigen::Vector3d centerOf(const KeyFrame& frame, std::size_t segment);

/// Places of points seen from above, sensor frame, metres.
std::vector<Eigen::Vector2f> seenFromAbove(const KeyFrame& frame,
                                           const std::vector<std::uint32_t>& points);

/// What the dynamic instances of a frame take up, sensor frame.
std::vector<Volume> dynamicVolumes(const KeyFrame& frame);

/// Unites segments: `groups[s]` is the group of segment s. The groups are numbered 0..count-1 in
/// the order of their first member; `frame.instances` must still be without ids. Members' points,
/// voxels and bounds are joined, and a group of several is described, classified and marked fused.
void uniteSegments(KeyFrame& frame,
                   const std::vector<std::uint32_t>& groups,
                   std::size_t count,
                   const ClassConfig& config);

/// Takes `points` (ascending, some but not all of the segment's) out of a segment and makes them a
/// new one, last in the list, of the same class. Boxes follow; features stay as they were. @returns
/// the index of the new segment
std::size_t splitSegment(KeyFrame& frame,
                         std::size_t segment,
                         const std::vector<std::uint32_t>& points);

}  // namespace segdf

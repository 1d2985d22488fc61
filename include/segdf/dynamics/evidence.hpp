// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/association.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/dynamics/plane_map.hpp"
#include "segdf/dynamics/visibility_image.hpp"

namespace segdf {

/// How often a place was looked at from other key frames, by answer.
struct PlaceEvidence {
  std::uint8_t free = 0;  ///< R_x
  /// H_x, from frames at least df.keep_delay away: nearer ones hit what moves slowly, too.
  std::uint8_t hit = 0;
};

/// What one other key frame says of a segment: F(C, j) of method.md 6.4.
struct PairVote {
  std::size_t scan = 0;      ///< running number of the other scan
  float seconds = 0.0F;      ///< to it, negative into the past
  std::uint32_t free = 0;    ///< points seen through
  std::uint32_t hit = 0;     ///< points found again
  bool informative = false;  ///< enough points were seen
  bool departure = false;    ///< not seen through, but empty, since its instance is elsewhere

  /// F, 0 when nothing was seen.
  float freeShare() const {
    return free + hit == 0 ? 0.0F : static_cast<float>(free) / static_cast<float>(free + hit);
  }
};

/// What a key frame brings to the comparison with others, and what these said of it.
struct FrameEvidence {
  double time = 0.0;  ///< seconds
  double way = 0.0;   ///< length of the path up to here, metres
  double step = 0.0;  ///< seconds since the key frame before
  VisibilityImage image;
  PlaneMap planes;
  std::vector<Eigen::Vector3f> registration_points;

  /// Places to look for in other frames, a row each, sensor frame, metres: every point of a
  /// segment, and of what is in no segment; of segments of more than 1000 points, or 300 where they
  /// are classified as buildings or vegetation, one for each curved voxel. Those of segment s are
  /// [begin[s], begin[s + 1]), those in no segment come last.
  Eigen::MatrixX3f places;
  std::vector<std::uint32_t> begin;
  /// The points that a place stands for: listed[first[k]] .. listed[first[k + 1] - 1].
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> listed;

  // For each place, as PlaceEvidence has them.
  std::vector<std::uint8_t> free;
  std::vector<std::uint8_t> hit;
  std::vector<std::vector<PairVote>> votes;  ///< for each segment, in the order of gathering

  PlaceEvidence answer(std::size_t place) const { return {free[place], hit[place]}; }
};

/// True from df.keep_delay on, either way in time: nearer frames hit what moves slowly, too. Frames
/// come with jitter, so that 0.05 s less is enough.
bool isFarInTime(double seconds, const DynamicConfig& config);

/// Image, planes and points of a segmented key frame.
FrameEvidence prepareEvidence(const KeyFrame& frame, const DynamicConfig& config);

/// Lists the places of the segments, for which nothing has been answered yet.
void listPlaces(KeyFrame& frame);

/// One point for each place of the segments; of those with 256 places and more for every fourth,
/// which tells as well which segments they touch.
PointsBySegment placePoints(const KeyFrame& frame);

/// The answers, for each point of the scan; no answers for points that are in no voxel.
std::vector<PlaceEvidence> evidenceByPoint(const KeyFrame& frame);

/// Looks for the places of `frame` in the image of `other` and notes the answers in
/// frame.evidence. Of segments with 32 places and more every fourth is looked at, and only where
/// one of these is seen through the others around it, too; else they have the answer of the one
/// before.
/// @param other_T_frame relative pose of the pair
void gatherEvidence(KeyFrame& frame,
                    const KeyFrame& other,
                    const Pose& other_T_frame,
                    const DynamicConfig& config,
                    int threads);

}  // namespace segdf

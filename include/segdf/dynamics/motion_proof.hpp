// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// An instance that the votes made dynamic: it was here then, and is no more, or was not yet. As
/// one of the views of a track, any instance.
struct MotionProof {
  std::size_t scan = 0;                              ///< running number
  Eigen::Vector3f size = Eigen::Vector3f::Zero();    ///< of its box, metres
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of its box in the map frame, metres
  double seconds = 0.0;                              ///< of motion that it stands for
};

/// In the order of their scans.
using MotionProofs = std::vector<MotionProof>;

/// Seconds of proven motion that outweigh that an instance stands here: eight scans at 10 Hz. A
/// proof stands for the time since the key frame before, but for no more than a step of 0.3 s:
/// three are asked for, however far apart key frames are.
inline constexpr double kStrongSeconds = 0.75;

/// What an instance would prove if the votes made it dynamic.
MotionProof proofOf(const KeyFrame& frame, std::size_t segment);

/// Seconds over which the segment's object was proven to move, by what may be another view or a
/// part of it. @param parked the segment was itself found again over and over
double secondsOfMotion(const MotionProofs& proofs, const Segment& segment, bool parked);

/// True when what has the size of the instance was proven to move, for kStrongSeconds, elsewhere.
bool movedAsAWhole(const MotionProofs& proofs, const MotionProof& here);

/// A side of a scan, in time.
enum class Side { kBefore, kAfter };

/// The proofs of scans before another, or the rest: of what does not move in a scan there is none
/// of that scan itself.
MotionProofs proofsOn(Side side, std::size_t scan, const MotionProofs& proofs);

/// True when what moved on that side of the segment's scan is another object: two or more scans of
/// that side in which the track was elsewhere found the segment here, for long enough, or, if none
/// saw through it, two in which the track had no place in common with it; or several found it on
/// the other side of scans in which the track moved elsewhere, and none saw through it: nothing
/// leaves and comes back to the same place unseen. Scans of the other side tell nothing: who came
/// and stopped here is seen to stand when the id passes on to somebody else.
/// @param proofs of the track, on that side
/// @param views of the track, moving or not, by all scans that may have voted
bool standsApart(const KeyFrame& frame,
                 std::size_t segment,
                 Side side,
                 const MotionProofs& proofs,
                 const MotionProofs& views,
                 const DynamicConfig& config);

/// True when the track moved only later than the segment's scan, and no scan since it did saw
/// through the segment: what leaves opens its place. What drives by closely takes an id along, too.
/// @param proofs at least one
bool staysBehind(const KeyFrame& frame,
                 std::size_t segment,
                 const MotionProofs& proofs,
                 const DynamicConfig& config);

}  // namespace segdf

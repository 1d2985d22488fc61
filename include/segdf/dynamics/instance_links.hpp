// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/association.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Fuse (Algorithm 2, line 18): where one static instance of `from` lies over several segments of
/// `to` of its own class, each touched by at least df.assoc of its voxels and together no larger
/// than one movable object, these become one segment. Shape histograms, the other veto of
/// method.md 6.2, are not computed yet. Segments of `to` are renumbered; `overlaps` follow.
void fuseSegments(const KeyFrame& from,
                  KeyFrame& to,
                  const Config& config,
                  std::vector<SegmentOverlap>& overlaps);

/// An instance that no segment continues is looked for so long, seconds.
inline constexpr double kLongestGap = 0.5;

/// Gives the instances of `to` their ids and velocities. Links with the last frame of at least
/// df.assoc are taken by falling number of common voxels, then smaller id, as long as both ends are
/// free. What is left is linked where a segment lies nearest to where an instance went on to, as
/// seen from above: things that are small or fast do not overlap with themselves. At most 2.5 m off
/// when it has a like size, or when one of the two frames saw through the other's place; 1 m when
/// the instance moved and looks otherwise now, or was lost since an older frame. Segments that no
/// link reaches get new ids; those that lie between where an instance of the last frame was and
/// where it would have gone on to, and touch it, have it as their parent.
/// Called when the frames have been compared: before, nobody has seen through anything.
/// @param before the key frames before `to`, oldest first, at least one
/// @param overlaps of the instances of the last of them
void passOnIds(const Window& before,
               KeyFrame& to,
               const std::vector<SegmentOverlap>& overlaps,
               const DynamicConfig& config,
               IdSource& ids);

}  // namespace segdf

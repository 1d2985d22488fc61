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

/// Gives the instances of `to` their ids. Links of at least df.assoc are taken by falling number of
/// common voxels, then smaller id, as long as both ends are free. What is left is linked where a
/// segment of like size lies nearest to where an instance went on to, at most 2.5 m off: things
/// that are small or fast do not overlap with themselves. Segments that no link reaches get new
/// ids.
void passOnIds(const KeyFrame& from,
               KeyFrame& to,
               const std::vector<SegmentOverlap>& overlaps,
               const DynamicConfig& config,
               IdSource& ids);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Makes dynamic what most of lies inside a dynamic instance (within df.foot_margin of its hull)
/// and was left static for want of evidence: fewer than df.keep_hits frames found it again. A
/// removed object fills its place, so that its pieces alone can be there.
void removeEnclosed(KeyFrame& frame, const DynamicConfig& config);

/// Removes object points of no instance that at least df.loose_votes others saw through, twice as
/// often as they found them again, unless they lie lower than df.foot_height (method.md 6.12, 7).
/// Within 2 m of a dynamic instance, of which they may be the far side, once is enough, and as
/// often as they were found again; within 1 m so it is from df.foot_bottom up, and for what nobody
/// saw anything of.
void removeLoosePoints(KeyFrame& frame, const DynamicConfig& config);

/// Settles what lies low around removed instances (method.md 6.7): ground points, and points of no
/// instance, under an instance go with it (wheels, feet, sills that were taken for ground), and its
/// own low points that are not under it stay as ground. Under: within df.foot_margin of the hull of
/// what is higher than df.foot_height.
void settleGround(KeyFrame& frame, const DynamicConfig& config);

}  // namespace segdf

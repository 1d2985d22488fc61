// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Removes object points of no instance that at least df.loose_votes others saw through, twice as
/// often as they found them again, unless they lie lower than df.foot_height (method.md 6.12, 7).
void removeLoosePoints(KeyFrame& frame, const DynamicConfig& config);

/// Settles what lies low around removed instances (method.md 6.7): ground points, and points of no
/// instance, under an instance go with it (wheels, feet, sills that were taken for ground), and its
/// own low points that are not under it stay as ground. Under: within df.foot_margin of the hull of
/// what is higher than df.foot_height.
void settleGround(KeyFrame& frame, const DynamicConfig& config);

}  // namespace segdf

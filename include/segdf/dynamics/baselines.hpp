// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// The older key frames with which the newest is compared: for each of df.times and df.ways the
/// youngest that is at least so far back (method.md 6.12, 3). @returns positions in the window,
/// ascending and unique
std::vector<std::size_t> selectBaselines(const Window& window, const DynamicConfig& config);

/// True when no comparison that selectBaselines() would make reaches back to the oldest key frame
/// any more, or the window is full.
bool isOutOfReach(const Window& window, const DynamicConfig& config);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// A key frame that the newest one of a window was compared with.
struct ComparedPair {
  std::size_t older = 0;                   ///< its position in the window
  Pose older_T_newest = Pose::Identity();  ///< as refined
};

/// Votes where looks tell nothing. Before the open sky, or where few lasers reach the road behind,
/// nothing returns from beyond an object, and nobody sees through the place that it left. A
/// departure is noted of a pair when an instance went on steadily from one place to another of its
/// size, and the scan that sees it here got no return from there, though an object there would be
/// as near to the sensor, and not behind others: a vote that counts as if all its points had been
/// seen through.
/// @param window whose newest frame has its ids; the frames' votes are added to
void noteDepartures(const Window& window, const std::vector<ComparedPair>& pairs);

}  // namespace segdf

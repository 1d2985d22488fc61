// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/evaluation/draft_protocol.hpp"
#include "segdf/io/png_file.hpp"

namespace segdf {

/// The draft's coloured map: TP green, FP red, FN blue.
struct VerdictColour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
};
VerdictColour colourOf(MapVerdict verdict);

/// The coloured map from above, x to the right and y up, on a dark ground: green is brighter where
/// more points stand one above the other, and mistakes are drawn last and a pixel wider, so that
/// single ones can be seen.
RgbImage drawVerdicts(const DraftScores& scores);

}  // namespace segdf

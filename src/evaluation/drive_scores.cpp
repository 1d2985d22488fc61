// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/drive_scores.hpp"

#include "segdf/core/config.hpp"

namespace segdf {

std::string bandName(std::size_t band) {
  const auto low = static_cast<double>(band) * PointScores::kBandWidth;
  if (band + 1 == PointScores::kBands) return "beyond " + formatNumber(low) + " m";
  return formatNumber(low) + "-" + formatNumber(low + PointScores::kBandWidth) + " m";
}

}  // namespace segdf

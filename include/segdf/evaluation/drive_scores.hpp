// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "segdf/evaluation/draft_protocol.hpp"
#include "segdf/evaluation/erasor_protocol.hpp"
#include "segdf/evaluation/point_scores.hpp"

namespace segdf {

/// What a drive scored, by each protocol that was asked for.
struct DriveScores {
  std::string name;
  std::size_t scans = 0;
  double range = 0.0;           ///< points within it were scored, metres
  std::size_t draft_scans = 0;  ///< of the scans, those that the draft's protocol took
  double draft_spacing = 0.0;   ///< at least so far apart, metres
  std::optional<PointScores> index;
  std::optional<DraftScores> draft;
  bool judged_only = false;  ///< ERASOR's without points of class 0, which it takes for static
  std::optional<VoxelScores> erasor;
  std::optional<PointScores> map;  ///< DynamicMap benchmark
};

/// "0-10 m", ..., "beyond 50 m": the range bands of PointScores.
std::string bandName(std::size_t band);

}  // namespace segdf

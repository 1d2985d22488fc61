// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/evaluation/drive_scores.hpp"

#include <nlohmann/json_fwd.hpp>

namespace segdf {

/// The figures of a drive for programs. With scores by index their keys stand at the top; the other
/// protocols' are under "draft", "erasor" and "dynamicmap".
nlohmann::ordered_json toJson(const DriveScores& scores);

}  // namespace segdf

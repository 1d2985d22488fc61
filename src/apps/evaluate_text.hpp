// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>

#include "segdf/evaluation/drive_scores.hpp"

namespace segdf::apps {

/// The figures for the terminal, each protocol under its name.
void printScores(std::ostream& out, const DriveScores& scores);

}  // namespace segdf::apps

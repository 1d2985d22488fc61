// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

#include "evaluate_protocols.hpp"
#include <nlohmann/json_fwd.hpp>

namespace segdf::apps {

/// The figures for the terminal, each protocol under its name.
void printScores(std::ostream& out, const DriveScores& scores, const ProtocolChoice& choice);

/// The same and more for programs. With scores by index their keys stand at the top; the other
/// protocols' are under "draft", "erasor" and "dynamicmap".
nlohmann::ordered_json toJson(const DriveScores& scores, const ProtocolChoice& choice);

}  // namespace segdf::apps

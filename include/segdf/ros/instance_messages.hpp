// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <segdf/FrameReport.h>
#include <segdf/LabelledInstanceArray.h>

#include "segdf/core/frame_result.hpp"

/// What a frame says, as messages of our own (msg/).
namespace segdf {

/// The instances of a frame, in the map frame, with the stamp of its scan.
LabelledInstanceArray toInstances(const FrameResult& frame, const std::string& frame_id);

/// The frame's own part of its report; the counts of the whole run are left at 0.
FrameReport toReport(const FrameResult& frame, const std::string& frame_id);

}  // namespace segdf

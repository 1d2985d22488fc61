// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/core/frame_result.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// The result of a decided key frame; its index is left to the caller.
FrameResult mappedResult(KeyFrame frame);

/// The result of a scan that was turned away: every point unjudged; its index is left to the
/// caller.
FrameResult rejectedResult(Scan scan, FrameStatus status);

}  // namespace segdf

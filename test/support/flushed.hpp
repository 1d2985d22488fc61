// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "segdf/pipeline/pipeline.hpp"

namespace segdf::test {

/// All frames that are still inside, at once.
inline std::vector<FrameResult> flushed(Pipeline& pipeline) {
  std::vector<FrameResult> frames;
  pipeline.flush([&frames](FrameResult frame) { frames.push_back(std::move(frame)); });
  return frames;
}

}  // namespace segdf::test

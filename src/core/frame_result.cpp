// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/frame_result.hpp"

namespace segdf {

std::string toString(FrameStatus status) {
  switch (status) {
    case FrameStatus::kMapped:
      return "mapped";
    case FrameStatus::kNotKeyFrame:
      return "not a key frame";
    case FrameStatus::kEmpty:
      return "no usable point";
    case FrameStatus::kInvalidPose:
      return "invalid pose";
    case FrameStatus::kTimeBackwards:
      return "time runs backwards";
  }
  return "unknown";
}

}  // namespace segdf

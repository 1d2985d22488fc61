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

std::string toString(Reason reason) {
  switch (reason) {
    case Reason::kAssociation:
      return "association";
    case Reason::kVotes:
      return "votes";
    case Reason::kLongLook:
      return "long_look";
    case Reason::kDeparture:
      return "departure";
    case Reason::kTrack:
      return "track";
    case Reason::kRestored:
      return "restored";
    case Reason::kSplit:
      return "split";
    case Reason::kKept:
      return "kept";
    case Reason::kLeft:
      return "left";
    case Reason::kEnclosed:
      return "enclosed";
    case Reason::kConsensus:
      return "consensus";
    case Reason::kNoEvidence:
      break;
  }
  return "no_evidence";
}

}  // namespace segdf

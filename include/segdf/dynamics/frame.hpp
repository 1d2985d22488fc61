// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/dynamics/footprint.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf {

/// What the dynamic filter knows of one segment: instance and verdict.
struct Instance {
  std::uint32_t id = 0;      ///< global instance id; 0 until given
  std::uint32_t parent = 0;  ///< instance that it was a part of, here or a key frame ago, 0 = none
  bool dynamic = false;
  bool fused = false;
  bool whole = false;               ///< its track moved elsewhere at its size: no part of it stands
  std::uint32_t static_votes = 0;   ///< HS
  std::uint32_t dynamic_votes = 0;  ///< HD
  std::uint32_t needed_votes = 0;   ///< HD votes that make it dynamic
  Reason reason = Reason::kNoEvidence;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of its box's centre, map frame, m/s
};

struct FrameEvidence;

/// A key frame in the sliding window.
struct KeyFrame {
  std::size_t index = 0;  ///< running number of the scan
  Scan scan;
  Segmentation seg;
  std::vector<Instance> instances;  ///< instance s belongs to seg.segments[s]
  bool judged = false;              ///< no further evidence will come
  /// Points of no instance that moved: ground points of moving objects, small clusters. Ascending.
  std::vector<std::uint32_t> removed;
  std::vector<Volume> moving;  ///< what its dynamic instances took up when it was judged
  std::vector<Volume> swept;   ///< those of the judged frames around, in this one's sensor frame
  std::shared_ptr<FrameEvidence> evidence;  ///< the filter's own; empty in literal mode
  double pose_misfit = 0.0;                 ///< metres, see FrameResult
  StageTimes times;
};

/// A frame that has been judged waits for so many further ones, which say what is there, too.
constexpr std::size_t kFramesAround = 5;

/// The key frames of the sliding window, oldest first. Never empty when handed to the filter.
using Window = std::vector<KeyFrame*>;

/// Gives out global instance ids, in the order of asking: 1, 2, 3 ...
class IdSource {
 public:
  std::uint32_t next() { return ++last_; }

 private:
  std::uint32_t last_ = 0;
};

}  // namespace segdf

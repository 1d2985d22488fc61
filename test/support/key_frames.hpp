// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf::test {

/// A scan segmented and classified, as the pipeline hands it to the dynamic filter.
inline std::unique_ptr<KeyFrame> makeKeyFrame(Scan scan, const Config& config) {
  auto frame = std::make_unique<KeyFrame>();
  frame->scan = std::move(scan);
  frame->seg = segmentScan(frame->scan, config, 1, frame->times);
  describeAndClassify(*frame, config.classes, 1);
  frame->instances.assign(frame->seg.segments.size(), Instance{});
  return frame;
}

/// The segment nearest to a place in the map frame (x, y), by box centre.
inline std::size_t segmentAt(const KeyFrame& frame, double x, double y) {
  std::size_t best = 0;
  double best_distance = 1e9;
  for (std::size_t s = 0; s < frame.seg.segments.size(); ++s) {
    const Eigen::Vector3d c = centerOf(frame, s);
    const double distance = std::hypot(c.x() - x, c.y() - y);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = s;
  }
  return best;
}

}  // namespace segdf::test

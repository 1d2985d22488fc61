// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/literal_filter.hpp"

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/instance_links.hpp"

namespace segdf {

LiteralFilter::LiteralFilter(const Config& config, IdSource& ids, int threads)
    : config_(config), grid_(config.cvi, config.input.min_range), ids_(ids), threads_(threads) {}

void LiteralFilter::observe(const Window& window) {
  KeyFrame& newest = *window.back();
  newest.instances.assign(newest.seg.segments.size(), Instance{});
  if (window.size() < 2) {
    for (Instance& instance : newest.instances) instance.id = ids_.next();
    return;
  }
  KeyFrame& previous = *window[window.size() - 2];
  std::vector<SegmentOverlap> overlaps =
      overlapSegments(previous, pointsOfSegments(previous), newest, grid_, threads_);
  fuseSegments(previous, newest, config_, overlaps);
  passOnIds({&previous}, newest, overlaps, config_.df, ids_);
  judge(previous, overlaps);
}

void LiteralFilter::decide(const Window& window, std::size_t count) {
  for (std::size_t i = 1; i < count; ++i) {
    KeyFrame& frame = *window[i];
    if (frame.judged) continue;
    judge(frame, overlapSegments(frame, pointsOfSegments(frame), *window[i - 1], grid_, threads_));
  }
}

void LiteralFilter::judge(KeyFrame& frame, const std::vector<SegmentOverlap>& overlaps) {
  for (std::size_t s = 0; s < overlaps.size(); ++s) {
    if (isTested(frame.seg.segments[s].object_class)) judgeInstance(frame, s, overlaps[s]);
  }
  frame.judged = true;
}

void LiteralFilter::judgeInstance(KeyFrame& frame,
                                  std::size_t segment,
                                  const SegmentOverlap& overlap) {
  Instance& instance = frame.instances[segment];
  instance.reason = Reason::kAssociation;
  if (overlap.neighbours.empty()) {
    instance.dynamic = true;
    ++instance.dynamic_votes;
  } else if (overlap.occupancy() >= config_.df.thre_occu) {
    ++instance.static_votes;
  } else {
    split(frame, segment, overlap.lost);
  }
}

void LiteralFilter::split(KeyFrame& frame,
                          std::size_t segment,
                          const std::vector<std::uint32_t>& lost) {
  const std::size_t part = splitSegment(frame, segment, lost);
  Instance& instance = frame.instances[part];
  instance.id = ids_.next();
  instance.parent = frame.instances[segment].id;
  instance.dynamic = true;
  instance.reason = Reason::kSplit;
  ++instance.dynamic_votes;
  ++frame.instances[segment].static_votes;
}

}  // namespace segdf

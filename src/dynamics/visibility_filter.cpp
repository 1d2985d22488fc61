// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/visibility_filter.hpp"

#include <algorithm>
#include <memory>

#include "segdf/classification/classifier.hpp"
#include "segdf/core/parallel.hpp"
#include "segdf/dynamics/association.hpp"
#include "segdf/dynamics/baselines.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/instance_links.hpp"
#include "segdf/dynamics/pose_refinement.hpp"
#include "segdf/dynamics/reattachment.hpp"
#include "segdf/dynamics/split_keep.hpp"
#include "segdf/dynamics/swept_volumes.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

/// The frames that still gather evidence.
Window open(const Window& window) {
  const auto first = std::find_if(window.begin(), window.end(),
                                  [](const KeyFrame* frame) { return !frame->judged; });
  return {first, window.end()};
}

}  // namespace

VisibilityFilter::VisibilityFilter(const Config& config, IdSource& ids, int threads)
    : config_(config),
      grid_(config.cvi, config.input.min_range),
      ids_(ids),
      tracks_(config.df),
      places_(config.df),
      threads_(threads) {}

bool VisibilityFilter::isSettled(const Window& window) const {
  return window.size() > kFramesAround && window[kFramesAround]->judged;
}

void VisibilityFilter::observe(const Window& all) {
  Window window = open(all);
  KeyFrame& newest = *window.back();
  newest.evidence = std::make_shared<FrameEvidence>(prepareEvidence(newest, config_.df));
  newest.instances.assign(newest.seg.segments.size(), Instance{});
  if (window.size() < 2) {
    listPlaces(newest);
    for (Instance& instance : newest.instances) instance.id = ids_.next();
    return places_.forget();
  }
  const KeyFrame& previous = *window[window.size() - 2];
  std::vector<SegmentOverlap> overlaps =
      overlapSegments(previous, placePoints(previous), newest, grid_, threads_);
  fuseSegments(previous, newest, config_, overlaps);
  listPlaces(newest);
  newest.evidence->way = previous.evidence->way +
                         (newest.scan.pose.translation() - previous.scan.pose.translation()).norm();
  newest.evidence->step = newest.evidence->time - previous.evidence->time;
  const std::vector<ComparedPair> pairs = compare(window);
  // After the comparison: that one left its place and another came is what links them.
  passOnIds({window.begin(), window.end() - 1}, newest, overlaps, config_.df, ids_);
  noteDepartures(window, pairs);
  if (remembers()) places_.look(newest);
  for (; isOutOfReach(window, config_.df); window.erase(window.begin())) {
    judge(window, 0);
    exchangeSweptVolumes(all, all.size() - window.size());
  }
}

std::vector<ComparedPair> VisibilityFilter::compare(const Window& window) {
  KeyFrame& newest = *window.back();
  const std::vector<std::size_t> baselines = selectBaselines(window, config_.df);
  std::vector<PairPose> poses(baselines.size());
  parallelFor(baselines.size(), threads_, [&](std::size_t k) {
    const KeyFrame& older = *window[baselines[k]];
    poses[k] = refinePair(older.scan.pose.inverse() * newest.scan.pose,
                          newest.evidence->registration_points, older.evidence->planes);
  });
  std::vector<ComparedPair> pairs;
  for (std::size_t k = 0; k < baselines.size(); ++k) {
    if (poses[k].quality < config_.df.min_quality) continue;
    KeyFrame& older = *window[baselines[k]];
    gatherEvidence(newest, older, poses[k].to_T_from, config_.df, threads_);
    gatherEvidence(older, newest, poses[k].to_T_from.inverse(), config_.df, threads_);
    pairs.push_back({baselines[k], poses[k].to_T_from});
  }
  return pairs;
}

void VisibilityFilter::judge(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  judgeByVotes(frame);
  tracks_.propagate(window, position);
  const std::vector<PlaceEvidence> by_point = evidenceByPoint(frame);
  splitMoved(frame, by_point, config_, grid_, ids_);
  keepStanding(frame, by_point, config_, grid_, ids_);
  tracks_.note(frame);
  if (removesParked()) consensus_.note(frame);
  frame.judged = true;
}

void VisibilityFilter::decide(const Window& window, std::size_t count) {
  const bool are_last = count == window.size();
  if (are_last) {
    const Window last = open(window);
    for (std::size_t i = 0; i < last.size(); ++i) {
      judge(last, i);
      exchangeSweptVolumes(window, window.size() - last.size() + i);
    }
  }
  for (std::size_t i = 0; i < count; ++i) finish(*window[i]);
  if (are_last) consensus_ = Consensus();
}

void VisibilityFilter::finish(KeyFrame& frame) {
  if (removesParked()) consensus_.apply(frame);
  removeEnclosed(frame, config_.df);
  if (remembers()) places_.note(frame);
}

void VisibilityFilter::settle(KeyFrame& frame) const {
  removeLoosePoints(frame, config_.df);
  settleGround(frame, config_.df);
}

void VisibilityFilter::judgeByVotes(KeyFrame& frame) const {
  for (std::size_t s = 0; s < frame.instances.size(); ++s) {
    const Segment& segment = frame.seg.segments[s];
    const Verdict verdict = judgeVotes(frame.evidence->votes[s], segment.object_class, config_.df);
    Instance& instance = frame.instances[s];
    instance.dynamic = verdict.dynamic;
    if (config_.df.semi_static == SemiStatic::kKeepWhileParked &&
        isParked(frame.evidence->votes[s], segment.points.size(), config_.df)) {
      instance.dynamic = false;
    }
    instance.dynamic_votes = verdict.dynamic_votes;
    instance.static_votes = verdict.static_votes;
    instance.needed_votes = verdict.needed;
    instance.reason = verdict.reason;
  }
}

}  // namespace segdf

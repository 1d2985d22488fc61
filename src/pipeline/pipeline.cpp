// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/pipeline.hpp"

#include <deque>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "segdf/core/stage_timer.hpp"
#include "segdf/dynamics/dynamic_filter.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/pose_misfit.hpp"
#include "segdf/pipeline/frame_output.hpp"
#include "segdf/pipeline/jump_detector.hpp"
#include "segdf/pipeline/scan_gate.hpp"

namespace segdf {

namespace {

const Config& validated(const Config& config, int threads) {
  validate(config);
  if (threads < 1) {
    throw std::invalid_argument("threads = " + std::to_string(threads) + " must be at least 1");
  }
  return config;
}

}  // namespace

class Pipeline::Impl {
 public:
  Impl(const Config& config, int threads)
      : config_(validated(config, threads)),
        threads_(threads),
        grid_(config.cvi, config.input.min_range),
        gate_(config.input),
        jump_detector_(config.input.max_jump),
        filter_(makeDynamicFilter(config_, ids_, threads)) {}

  std::vector<FrameResult> process(Scan scan) {
    std::vector<FrameResult> results;
    const bool jump = jump_detector_.jumps(scan);
    if (jump) results = decideAll();
    enter(std::move(scan), jump);
    for (FrameResult& result : release(false)) results.push_back(std::move(result));
    return results;
  }

  std::vector<FrameResult> flush() {
    jump_detector_ = JumpDetector(config_.input.max_jump);
    return decideAll();
  }

 private:
  std::vector<FrameResult> decideAll() {
    const Window window = keyFrames();
    for (std::size_t i = 0; i < window.size(); ++i) filter_->decide(window, i);
    gate_ = ScanGate(config_.input);
    return release(true);
  }

  /// A scan inside the window: a key frame, or the ready result of one that was turned away.
  struct Entry {
    std::size_t index = 0;
    FrameResult rejected;
    std::unique_ptr<KeyFrame> key;
    bool after_jump = false;
  };

  void enter(Scan scan, bool after_jump) {
    const FrameStatus status = gate_.admit(scan);
    if (status == FrameStatus::kMapped) {
      addKeyFrame(std::move(scan));
    } else {
      entries_.push_back({next_index_++, rejectedResult(std::move(scan), status), nullptr});
    }
    entries_.back().after_jump = after_jump;
  }

  /// Seg(P_k): segments, describes and classifies a scan, then lets the filter compare it.
  void addKeyFrame(Scan scan) {
    auto frame = std::make_unique<KeyFrame>();
    frame->index = next_index_;
    frame->scan = std::move(scan);
    frame->seg = segmentScan(frame->scan, config_, threads_, frame->times);
    {
      const StageTimer timer(frame->times.classification);
      describeAndClassify(*frame, config_.classes, threads_);
    }
    const StageTimer timer(frame->times.dynamics);
    measureMisfit(*frame);
    entries_.push_back({next_index_++, {}, std::move(frame)});
    filter_->observe(keyFrames());
    forgetDetails(keyFrames());
  }

  /// A third of a frame's memory is for questions to the newest frame and to the one before it.
  static void forgetDetails(const Window& window) {
    window.back()->seg.forgetSurfaces();
    if (window.size() > 2) window[window.size() - 3]->seg.forgetVoxels();
  }

  void measureMisfit(KeyFrame& frame) const {
    const Window window = keyFrames();
    frame.pose_misfit = window.empty() ? std::numeric_limits<double>::quiet_NaN()
                                       : poseMisfit(frame, *window.back(), grid_);
  }

  Window keyFrames() const {
    Window window;
    for (const Entry& entry : entries_) {
      if (entry.key) window.push_back(entry.key.get());
    }
    return window;
  }

  /// Hands out the oldest entries up to the first key frame that may still learn something.
  std::vector<FrameResult> release(bool all) {
    std::vector<FrameResult> results;
    for (Window window = keyFrames(); !entries_.empty(); window = keyFrames()) {
      Entry& oldest = entries_.front();
      if (oldest.key) {
        if (!all && !filter_->isSettled(window)) break;
        filter_->decide(window, 0);
      }
      results.push_back(oldest.key ? mappedResult(std::move(*oldest.key))
                                   : std::move(oldest.rejected));
      results.back().index = oldest.index;
      results.back().after_jump = oldest.after_jump;
      entries_.pop_front();
    }
    return results;
  }

  Config config_;
  int threads_;
  CurvedGrid grid_;
  ScanGate gate_;
  JumpDetector jump_detector_;
  IdSource ids_;
  std::unique_ptr<DynamicFilter> filter_;
  std::deque<Entry> entries_;
  std::size_t next_index_ = 0;
};

Pipeline::Pipeline(const Config& config, int threads)
    : impl_(std::make_unique<Impl>(config, threads)) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

std::vector<FrameResult> Pipeline::process(Scan scan) { return impl_->process(std::move(scan)); }

std::vector<FrameResult> Pipeline::flush() { return impl_->flush(); }

}  // namespace segdf

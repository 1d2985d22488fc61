// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/pipeline.hpp"

#include <algorithm>
#include <deque>
#include <future>
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
        segmentation_threads_((threads + 1) / 2),
        when_(threads > 1 ? std::launch::async : std::launch::deferred),
        grid_(config.cvi, config.input.min_range),
        gate_(config.input),
        jump_detector_(config.input.max_jump),
        filter_threads_(std::max(1, threads / 2)),
        filter_(makeDynamicFilter(config_, ids_, filter_threads_)) {}

  std::vector<FrameResult> process(Scan scan) {
    std::vector<FrameResult> results;
    const Take append = [&results](FrameResult result) { results.push_back(std::move(result)); };
    const bool jump = jump_detector_.jumps(scan);
    if (jump) decideAll(append);
    Entry entry = makeEntry(std::move(scan), jump);
    takeFiltered(append);
    entries_.push_back(std::move(entry));
    filtering_ = std::async(when_, [this] { return filterNewest(); });
    return results;
  }

  void flush(const Take& take) {
    jump_detector_ = JumpDetector(config_.input.max_jump);
    decideAll(take);
  }

 private:
  /// What the filter, which works beside the segmentation, says of the scan before.
  void takeFiltered(const Take& take) {
    if (!filtering_.valid()) return;
    for (FrameResult& result : filtering_.get()) take(std::move(result));
  }

  void decideAll(const Take& take) {
    takeFiltered(take);
    const Window window = keyFrames();
    filter_->decide(window, window.size());
    gate_ = ScanGate(config_.input);
    std::vector<Revocation> revoked = filter_->takeRevocations();
    // Each is made ready while the one before is taken.
    for (std::future<FrameResult> next = releasing(); next.valid();) {
      FrameResult ready = next.get();
      next = releasing();
      ready.revoked = std::exchange(revoked, {});
      take(std::move(ready));
    }
  }

  /// The oldest entry, on its way out; not valid when there is none.
  std::future<FrameResult> releasing() {
    if (entries_.empty()) return {};
    return std::async(when_, [this] { return releaseOldest(); });
  }

  /// A scan inside the window: a key frame, or the ready result of one that was turned away.
  struct Entry {
    std::size_t index = 0;
    FrameResult rejected;
    std::unique_ptr<KeyFrame> key;
    bool after_jump = false;
  };

  Entry makeEntry(Scan scan, bool after_jump) {
    Entry entry;
    entry.index = next_index_++;
    entry.after_jump = after_jump;
    const FrameStatus status = gate_.admit(scan);
    if (status == FrameStatus::kMapped) {
      entry.key = segmented(std::move(scan), entry.index);
    } else {
      entry.rejected = rejectedResult(std::move(scan), status);
    }
    return entry;
  }

  /// Seg(P_k): segments a scan. Touches no other frame.
  std::unique_ptr<KeyFrame> segmented(Scan scan, std::size_t index) const {
    auto frame = std::make_unique<KeyFrame>();
    frame->index = index;
    frame->scan = std::move(scan);
    frame->seg = segmentScan(frame->scan, config_, segmentation_threads_, frame->times);
    return frame;
  }

  /// Classifies the newest key frame and lets the filter compare it: the shorter part of the work
  /// on a scan, beside the segmentation of the next. @return the frames that leave the window
  std::vector<FrameResult> filterNewest() {
    if (entries_.back().key) {
      classify(*entries_.back().key);
      const Window window = keyFrames();
      const StageTimer timer(window.back()->times.dynamics);
      measureMisfit(window);
      filter_->observe(window);
      forgetDetails(window);
    }
    return releaseSettled();
  }

  void classify(KeyFrame& frame) const {
    const StageTimer timer(frame.times.classification);
    describeAndClassify(frame, config_.classes, filter_threads_);
  }

  /// Surfaces are asked for of the newest frame only, voxels of the two before it, too.
  static void forgetDetails(const Window& window) {
    window.back()->seg.forgetSurfaces();
    if (window.size() > 2) window[window.size() - 3]->seg.forgetVoxels();
  }

  void measureMisfit(const Window& window) const {
    KeyFrame& newest = *window.back();
    newest.pose_misfit = window.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                                           : poseMisfit(newest, *window[window.size() - 2], grid_);
  }

  Window keyFrames() const {
    Window window;
    for (const Entry& entry : entries_) {
      if (entry.key) window.push_back(entry.key.get());
    }
    return window;
  }

  /// Hands out the oldest entries up to the first key frame that may still learn something.
  std::vector<FrameResult> releaseSettled() {
    std::vector<FrameResult> results;
    for (Window window = keyFrames(); !entries_.empty(); window = keyFrames()) {
      if (entries_.front().key) {
        if (!filter_->isSettled(window)) break;
        filter_->decide(window, 1);
      }
      results.push_back(releaseOldest());
    }
    if (!results.empty()) results.front().revoked = filter_->takeRevocations();
    return results;
  }

  /// Takes the oldest entry, which has been decided, out of the window.
  FrameResult releaseOldest() {
    Entry oldest = std::move(entries_.front());
    entries_.pop_front();
    if (oldest.key) filter_->settle(*oldest.key);
    FrameResult result =
        oldest.key ? mappedResult(std::move(*oldest.key)) : std::move(oldest.rejected);
    result.index = oldest.index;
    result.after_jump = oldest.after_jump;
    return result;
  }

  Config config_;
  int segmentation_threads_;
  std::launch when_;  ///< the filter works
  CurvedGrid grid_;
  ScanGate gate_;
  JumpDetector jump_detector_;
  IdSource ids_;
  int filter_threads_;  ///< beside them
  std::unique_ptr<DynamicFilter> filter_;
  std::deque<Entry> entries_;
  std::size_t next_index_ = 0;
  std::future<std::vector<FrameResult>> filtering_;  ///< last: ends before what it works on
};

Pipeline::Pipeline(const Config& config, int threads)
    : impl_(std::make_unique<Impl>(config, threads)) {}
Pipeline::~Pipeline() = default;
Pipeline::Pipeline(Pipeline&&) noexcept = default;
Pipeline& Pipeline::operator=(Pipeline&&) noexcept = default;

std::vector<FrameResult> Pipeline::process(Scan scan) { return impl_->process(std::move(scan)); }

void Pipeline::flush(const Take& take) { impl_->flush(take); }

}  // namespace segdf

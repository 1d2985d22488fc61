// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"

namespace segdf {

/// The engine that nodelet, offline runner and tests drive: draft section III, (3) and (4).
///
/// Scans go in by process(), in order of time; frames come out when they leave the sliding window
/// of key frames, in the order in which they went in, each exactly once and with a label for every
/// point. flush() hands out what is still inside. The filter compares a scan while the next one is
/// segmented, in a thread of its own if there is more than one: a frame comes out one call after
/// the scan that let it leave. The result is a function of scans and
/// configuration: it does not depend on the number of threads, on the clock, or on how long the
/// caller waits between scans. Where the pose jumps (input.max_jump), the window is decided as by
/// flush() and the scan starts a new one. Memory is bounded by the window, not by the length of the
/// drive. Not thread-safe.
class Pipeline {
 public:
  /// @param threads worker threads, at least 1
  /// @throws std::invalid_argument naming the parameter, its value and its bound
  explicit Pipeline(const Config& config, int threads = 1);
  ~Pipeline();
  Pipeline(Pipeline&&) noexcept;
  Pipeline& operator=(Pipeline&&) noexcept;
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  /// Takes the next scan. A scan that cannot be used is returned, in its turn, with the status that
  /// says why; it never throws for bad data.
  std::vector<FrameResult> process(Scan scan);

  using Take = std::function<void(FrameResult)>;

  /// Decides all frames still in the window, hands them out one after the other, and forgets the
  /// past: the next scan starts a new session, in which instance ids and frame numbers go on and
  /// time may start anew. With more than one thread `take` works on a frame while the next one is
  /// made ready. @throws what `take` throws; after that the pipeline is of no use
  void flush(const Take& take);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Df of formula (4): decides which instances move. One implementation per mode, chosen by df.mode;
/// a mode that needs more evidence asks for a longer window and decides when a frame is about to
/// leave it.
class DynamicFilter {
 public:
  DynamicFilter() = default;
  virtual ~DynamicFilter() = default;
  DynamicFilter(const DynamicFilter&) = delete;
  DynamicFilter& operator=(const DynamicFilter&) = delete;

  /// True when no further key frame can tell more about the oldest of the window: it may leave.
  virtual bool isSettled(const Window& window) const = 0;

  /// The newest key frame (back of the window) has been segmented and classified: gives its
  /// segments their instance ids and gathers evidence.
  virtual void observe(const Window& window) = 0;

  /// The first `count` frames are about to leave; when these are all, no further one will come:
  /// makes the verdicts on their instances final.
  virtual void decide(const Window& window, std::size_t count) = 0;

  /// Of a frame that has been decided and leaves: its points that are in no instance follow the
  /// verdicts. May run beside anything that is done with other frames.
  virtual void settle(KeyFrame& frame) const = 0;

  /// What observe() found out about frames that have left the window, since the last call.
  virtual std::vector<Revocation> takeRevocations() = 0;
};

/// The filter that config.df.mode names. @param ids outlives the filter
std::unique_ptr<DynamicFilter> makeDynamicFilter(const Config& config, IdSource& ids, int threads);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <string>

#include <segdf/FrameReport.h>

namespace segdf {

/// Some durations, in seconds.
class Durations {
 public:
  void add(double seconds) {
    ++count_;
    sum_ += seconds;
    greatest_ = std::max(greatest_, seconds);
  }
  bool empty() const { return count_ == 0; }
  /// @pre not empty
  double mean() const { return sum_ / static_cast<double>(count_); }
  double greatest() const { return greatest_; }

 private:
  std::size_t count_ = 0;
  double sum_ = 0.0;
  double greatest_ = 0.0;
};

/// What became of everything that came in. Nothing is lost without being counted here:
/// clouds = processed + scansWaiting() + dropped + unusable + unmatched + clouds_waiting.
struct Counts {
  std::size_t clouds = 0;          ///< received
  std::size_t poses = 0;           ///< odometry messages received
  std::size_t clouds_waiting = 0;  ///< for their pose
  std::size_t unmatched = 0;       ///< clouds whose pose never came
  std::size_t pairs = 0;           ///< clouds with their pose
  std::size_t dropped = 0;         ///< pairs for which the filter's queue had no room
  std::size_t unusable = 0;        ///< pairs that could not be made into a scan
  std::size_t processed = 0;       ///< scans handed to the filter
  std::size_t frames = 0;          ///< of these, those that have left the window
  std::size_t lost = 0;            ///< clouds that never came, by gaps in header.seq
  std::size_t time_resets = 0;
  std::size_t jump_resets = 0;
  Durations filtering;  ///< of a scan, from its messages to topics and files
  Durations waiting;    ///< of a scan, for the filter

  std::size_t scansWaiting() const { return pairs - dropped - unusable - processed; }
};

/// The counts, shared by the ROS threads and the worker.
class Ledger {
 public:
  template <class Change>
  void change(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(counts_);
  }
  Counts counts() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return counts_;
  }

 private:
  mutable std::mutex mutex_;
  Counts counts_;
};

/// One line: "35 clouds received: 33 filtered, 2 dropped, ...", and how long a scan took and
/// waited.
std::string toText(const Counts& counts);

/// Puts the counts into a report of a frame.
void fill(FrameReport& report, const Counts& counts);

}  // namespace segdf

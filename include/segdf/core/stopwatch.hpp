// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>

namespace segdf {

/// Tells the time since it was made. For reports only.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace segdf

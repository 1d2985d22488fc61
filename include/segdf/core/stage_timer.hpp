// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "segdf/core/stopwatch.hpp"

namespace segdf {

/// Adds the seconds of its own life to a total. For reports only.
class StageTimer {
 public:
  explicit StageTimer(double& total) : total_(total) {}
  ~StageTimer() { total_ += watch_.seconds(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  double& total_;
  Stopwatch watch_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <iostream>
#include <string>

#include <unistd.h>

namespace segdf::apps {

namespace {
constexpr std::size_t kBarWidth = 40;
constexpr std::size_t kPlainStep = 10;  // percent
}  // namespace

Progress::Progress(std::size_t total) : total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::show(std::size_t done) {
  if (total_ == 0) return;
  const std::size_t percent = 100 * done / total_;
  if (percent == last_) return;
  if (terminal_) {
    drawBar(percent);
  } else if (percent / kPlainStep != last_ / kPlainStep) {
    std::cerr << percent << " % (" << done << " of " << total_ << " scans)\n";
  }
  last_ = percent;
}

void Progress::drawBar(std::size_t percent) const {
  const std::size_t filled = kBarWidth * percent / 100;
  std::cerr << "\r[" << std::string(filled, '=') << std::string(kBarWidth - filled, ' ') << "] "
            << percent << " %" << std::flush;
}

void Progress::finish() const {
  if (terminal_ && last_ > 0) std::cerr << '\n';
}

}  // namespace segdf::apps

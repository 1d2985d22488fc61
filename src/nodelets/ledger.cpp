// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/ledger.hpp"

#include <iomanip>
#include <sstream>

namespace segdf {
namespace {

std::string toText(const Durations& durations) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << durations.mean() << " s on average, "
       << durations.greatest() << " s at most";
  return text.str();
}

}  // namespace

std::string toText(const Counts& counts) {
  std::ostringstream text;
  text << counts.clouds << " clouds received: " << counts.processed << " filtered, "
       << counts.scansWaiting() << " waiting for the filter, " << counts.dropped << " dropped, "
       << counts.unusable << " unusable, " << counts.unmatched << " without pose, "
       << counts.clouds_waiting << " waiting for a pose";
  if (!counts.filtering.empty() && !counts.waiting.empty()) {
    text << "; a scan waited " << toText(counts.waiting) << ", and took "
         << toText(counts.filtering);
  }
  return text.str();
}

void fill(FrameReport& report, const Counts& counts) {
  report.clouds_received = counts.clouds;
  report.clouds_waiting = counts.clouds_waiting;
  report.clouds_unmatched = counts.unmatched;
  report.scans_waiting = counts.scansWaiting();
  report.scans_dropped = counts.dropped;
  report.scans_unusable = counts.unusable;
  report.scans_processed = counts.processed;
  report.messages_lost = counts.lost;
  report.time_resets = static_cast<std::uint32_t>(counts.time_resets);
  report.jump_resets = static_cast<std::uint32_t>(counts.jump_resets);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/baselines.hpp"

#include <algorithm>

#include "segdf/dynamics/evidence.hpp"

namespace segdf {

namespace {

// Frames come with jitter: one that is this much short of a baseline still has it.
constexpr double kSlack = 0.05;

/// Position of the youngest frame for which `distance` reaches `least`; window.size() when none
/// does. Distances grow towards the front.
template <class Distance>
std::size_t youngest(const Window& window, double least, const Distance& distance) {
  for (std::size_t k = window.size() - 1; k-- > 0;) {
    if (distance(*window[k]->evidence) >= (1.0 - kSlack) * least) return k;
  }
  return window.size();
}

}  // namespace

std::vector<std::size_t> selectBaselines(const Window& window, const DynamicConfig& config) {
  const FrameEvidence& newest = *window.back()->evidence;
  std::vector<std::size_t> selected;
  for (double seconds : config.times) {
    selected.push_back(
        youngest(window, seconds, [&](const FrameEvidence& e) { return newest.time - e.time; }));
  }
  for (double metres : config.ways) {
    selected.push_back(
        youngest(window, metres, [&](const FrameEvidence& e) { return newest.way - e.way; }));
  }
  std::sort(selected.begin(), selected.end());
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  if (!selected.empty() && selected.back() == window.size()) selected.pop_back();
  return selected;
}

bool isOutOfReach(const Window& window, const DynamicConfig& config) {
  if (window.size() > static_cast<std::size_t>(config.window)) return true;
  const FrameEvidence& oldest = *window.front()->evidence;
  const FrameEvidence& newest = *window.back()->evidence;
  const double seconds = *std::max_element(config.times.begin(), config.times.end());
  const double metres = *std::max_element(config.ways.begin(), config.ways.end());
  return newest.time - oldest.time > (1.0 + kSlack) * seconds &&
         newest.way - oldest.way > (1.0 + kSlack) * metres;
}

}  // namespace segdf

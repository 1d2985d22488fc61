// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/point_scores.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

namespace sk = semantic_kitti;

namespace {

std::size_t bandOf(double range) {
  constexpr auto kLast = static_cast<double>(PointScores::kBands - 1);
  return static_cast<std::size_t>(std::clamp(range / PointScores::kBandWidth, 0.0, kLast));
}

}  // namespace

std::optional<double> Share::percent() const {
  if (whole == 0) return std::nullopt;
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void PointScores::add(std::uint32_t truth, double range, bool kept) {
  const std::uint16_t semantic_class = sk::classOf(truth);
  if (sk::isIgnored(semantic_class)) return;
  const bool moving = sk::isMoving(semantic_class);
  by_class_[semantic_class][bandOf(range)].count(kept != moving);
  const std::uint16_t instance = sk::instanceOf(truth);
  if (instance != 0) instances_[{semantic_class, instance}].count(!kept);
  if (moving) {
    moving_.count(!kept);
    return;
  }
  static_.count(kept);
  if (sk::isParkedMovable(semantic_class)) parked_.count(kept);
  if (sk::isGround(semantic_class)) ground_.count(kept);
}

std::optional<double> PointScores::associatedAccuracy() const {
  const auto sa = static_.percent();
  const auto da = moving_.percent();
  if (!sa || !da) return std::nullopt;
  return std::sqrt(*sa * *da);
}

std::optional<double> PointScores::harmonicAccuracy() const {
  const auto sa = static_.percent();
  const auto da = moving_.percent();
  if (!sa || !da) return std::nullopt;
  return *sa + *da > 0.0 ? 2.0 * *sa * *da / (*sa + *da) : 0.0;
}

PointScores::ByBand PointScores::sumByBand(bool moving) const {
  ByBand sum{};
  for (const auto& [semantic_class, bands] : by_class_) {
    if (sk::isMoving(semantic_class) != moving) continue;
    for (std::size_t k = 0; k < kBands; ++k) {
      sum[k].part += bands[k].part;
      sum[k].whole += bands[k].whole;
    }
  }
  return sum;
}

Share PointScores::rightOfClass(std::uint16_t semantic_class) const {
  Share sum;
  const auto found = by_class_.find(semantic_class);
  if (found == by_class_.end()) return sum;
  for (const Share& band : found->second) {
    sum.part += band.part;
    sum.whole += band.whole;
  }
  return sum;
}

Share PointScores::instancesHalfRemoved(bool moving) const {
  Share share;
  for (const auto& [key, removed] : instances_) {
    if (sk::isMoving(key.first) != moving || removed.whole < kMinInstancePoints) continue;
    share.count(2 * removed.part >= removed.whole);
  }
  return share;
}

}  // namespace segdf

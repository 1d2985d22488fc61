// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/index_protocol.hpp"

#include <cmath>
#include <stdexcept>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

namespace sk = semantic_kitti;

std::optional<double> Share::percent() const {
  if (whole == 0) return std::nullopt;
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void IndexProtocol::add(const std::vector<Point>& points,
                        const std::vector<std::uint32_t>& truth,
                        const std::vector<std::uint32_t>& estimate) {
  if (truth.size() != points.size() || estimate.size() != points.size()) {
    throw std::invalid_argument("points and labels differ in number");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Not "range > limit": a NaN coordinate is not within the range either.
    if (!(points[i].position().cast<double>().norm() <= range_)) continue;
    if (!sk::isIgnored(sk::classOf(truth[i]))) addPoint(truth[i], estimate[i]);
  }
}

void IndexProtocol::addPoint(std::uint32_t truth, std::uint32_t estimate) {
  const std::uint16_t semantic_class = sk::classOf(truth);
  const std::uint16_t estimated = sk::classOf(estimate);
  const bool kept = estimated != sk::kUnlabelled && estimated != sk::kDynamic;
  const auto count = [](Share& share, bool hit) {
    ++share.whole;
    share.part += hit ? 1 : 0;
  };
  if (!sk::isMoving(semantic_class)) {
    count(static_, kept);
    if (sk::isParkedMovable(semantic_class)) count(parked_, kept);
    return;
  }
  count(moving_, !kept);
  count(by_class_[semantic_class - sk::kFirstMoving], !kept);
  const std::uint16_t instance = sk::instanceOf(truth);
  if (instance != 0) count(instances_[{semantic_class, instance}], !kept);
}

std::optional<double> IndexProtocol::associatedAccuracy() const {
  const auto sa = static_.percent();
  const auto da = moving_.percent();
  if (!sa || !da) return std::nullopt;
  return std::sqrt(*sa * *da);
}

std::optional<double> IndexProtocol::harmonicAccuracy() const {
  const auto sa = static_.percent();
  const auto da = moving_.percent();
  if (!sa || !da) return std::nullopt;
  return *sa + *da > 0.0 ? 2.0 * *sa * *da / (*sa + *da) : 0.0;
}

Share IndexProtocol::instancesRemoved() const {
  Share share;
  for (const auto& [key, removed] : instances_) {
    if (removed.whole < kMinInstancePoints) continue;
    ++share.whole;
    share.part += 2 * removed.part >= removed.whole ? 1 : 0;
  }
  return share;
}

}  // namespace segdf

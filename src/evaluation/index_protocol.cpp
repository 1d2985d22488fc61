// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/index_protocol.hpp"

#include <stdexcept>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

void IndexProtocol::add(const std::vector<Point>& points,
                        const std::vector<std::uint32_t>& truth,
                        const std::vector<std::uint32_t>& estimate) {
  if (truth.size() != points.size() || estimate.size() != points.size()) {
    throw std::invalid_argument("points and labels differ in number");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double range = points[i].position().cast<double>().norm();
    // Not "range > limit": a NaN coordinate is not within the range either.
    if (range <= range_) scores_.add(truth[i], range, isKeptLabel(estimate[i]));
  }
}

bool isKeptLabel(std::uint32_t estimate) {
  const std::uint16_t estimated = semantic_kitti::classOf(estimate);
  return estimated != semantic_kitti::kUnlabelled && estimated != semantic_kitti::kDynamic;
}

}  // namespace segdf

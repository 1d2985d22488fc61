// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/horizontal_extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace segdf {

namespace {

constexpr float kPi = 3.14159265F;

}  // namespace

float HorizontalExtent::alongAxis(std::size_t direction, float x, float y) {
  static const auto axes = [] {
    std::array<std::array<float, 2>, kDirections> result{};
    for (std::size_t k = 0; k < kDirections; ++k) {
      const float angle = kPi * static_cast<float>(k) / static_cast<float>(kDirections);
      result[k] = {std::cos(angle), std::sin(angle)};
    }
    return result;
  }();
  return axes[direction][0] * x + axes[direction][1] * y;
}

HorizontalExtent::HorizontalExtent() {
  low_.fill(std::numeric_limits<float>::infinity());
  high_.fill(-std::numeric_limits<float>::infinity());
}

void HorizontalExtent::add(float x, float y) {
  for (std::size_t k = 0; k < kDirections; ++k) {
    const float along = alongAxis(k, x, y);
    low_[k] = std::min(low_[k], along);
    high_[k] = std::max(high_[k], along);
  }
}

void HorizontalExtent::add(const HorizontalExtent& other) {
  for (std::size_t k = 0; k < kDirections; ++k) {
    low_[k] = std::min(low_[k], other.low_[k]);
    high_[k] = std::max(high_[k], other.high_[k]);
  }
}

bool HorizontalExtent::contains(float x, float y, float margin) const {
  for (std::size_t k = 0; k < kDirections; ++k) {
    const float along = alongAxis(k, x, y);
    if (along < low_[k] - margin || along > high_[k] + margin) return false;
  }
  return true;
}

std::size_t HorizontalExtent::longest() const {
  std::size_t best = 0;
  for (std::size_t k = 1; k < kDirections; ++k) {
    if (extent(k) > extent(best)) best = k;
  }
  return best;
}

}  // namespace segdf

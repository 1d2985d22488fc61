// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "segdf/classification/features.hpp"

namespace segdf {

namespace {

constexpr float kPi = 3.14159265F;
constexpr std::size_t kSteps = 30;  // over 90 degrees: 3 degrees each

/// Least and greatest coordinates along directions 3 degrees apart over half a turn.
class Projections {
 public:
  Projections() {
    low_.fill(std::numeric_limits<float>::infinity());
    high_.fill(-std::numeric_limits<float>::infinity());
  }

  void add(float x, float y) {
    static const Directions directions;
    for (std::size_t k = 0; k < kCount; ++k) {
      const float along = directions.cosine[k] * x + directions.sine[k] * y;
      low_[k] = along < low_[k] ? along : low_[k];
      high_[k] = along > high_[k] ? along : high_[k];
    }
  }

  /// Bounding rectangle with its first side in direction k.
  Eigen::Vector2f sizeAt(std::size_t k) const {
    return {high_[k] - low_[k], high_[k + kSteps] - low_[k + kSteps]};
  }
  Eigen::Vector2f centerAt(std::size_t k) const {
    const float yaw = yawOf(k);
    const Eigen::Vector2f along(std::cos(yaw), std::sin(yaw));
    const Eigen::Vector2f across(-along.y(), along.x());
    return along * (high_[k] + low_[k]) / 2.0F +
           across * (high_[k + kSteps] + low_[k + kSteps]) / 2.0F;
  }
  static float yawOf(std::size_t k) {
    return kPi / 2.0F * static_cast<float>(k) / static_cast<float>(kSteps);
  }

 private:
  static constexpr std::size_t kCount = 2 * kSteps;
  struct Directions {
    std::array<float, kCount> cosine{};
    std::array<float, kCount> sine{};
    Directions() {
      for (std::size_t k = 0; k < kCount; ++k) {
        cosine[k] = std::cos(yawOf(k));
        sine[k] = std::sin(yawOf(k));
      }
    }
  };

  std::array<float, kCount> low_{};
  std::array<float, kCount> high_{};
};

std::size_t smallestRectangle(const Projections& projections) {
  std::size_t best = 0;
  float best_area = std::numeric_limits<float>::infinity();
  for (std::size_t k = 0; k < kSteps; ++k) {
    const Eigen::Vector2f size = projections.sizeAt(k);
    // A line has no area in any direction: its half perimeter decides.
    const float area = size.prod() + 1e-3F * size.sum();
    if (area >= best_area) continue;
    best_area = area;
    best = k;
  }
  return best;
}

}  // namespace

UprightBox fitBox(const std::vector<Point>& points, const std::vector<std::uint32_t>& indices) {
  UprightBox box;
  if (indices.empty()) return box;
  // Offsets from one point keep float exact far from the sensor.
  const Eigen::Vector3f origin = points[indices.front()].position();
  Projections projections;
  float low = origin.z();
  float high = origin.z();
  for (std::uint32_t i : indices) {
    const Point& p = points[i];
    projections.add(p.x - origin.x(), p.y - origin.y());
    low = std::min(low, p.z);
    high = std::max(high, p.z);
  }
  const std::size_t best = smallestRectangle(projections);
  const Eigen::Vector2f size = projections.sizeAt(best);
  const Eigen::Vector2f center = projections.centerAt(best);
  box.center = {origin.x() + center.x(), origin.y() + center.y(), (low + high) / 2.0F};
  box.size = {size.maxCoeff(), size.minCoeff(), high - low};
  box.yaw = Projections::yawOf(best) + (size.x() < size.y() ? kPi / 2.0F : 0.0F);
  return box;
}

}  // namespace segdf

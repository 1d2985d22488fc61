// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Geometry>

#include "segdf/classification/features.hpp"

namespace segdf {

namespace {

constexpr float kPi = 3.14159265F;
constexpr int kSteps = 30;  // over 90 degrees: 3 degrees each

using Cloud2d = Eigen::Matrix<float, 2, Eigen::Dynamic>;

struct Rectangle {
  Eigen::Vector2f center = Eigen::Vector2f::Zero();
  Eigen::Vector2f size = Eigen::Vector2f::Zero();
  float yaw = 0.0F;
};

/// Bounding rectangle with its first side at `yaw`.
Rectangle rectangleAt(const Cloud2d& cloud, float yaw) {
  const Eigen::Vector2f along(std::cos(yaw), std::sin(yaw));
  const Eigen::Vector2f across(-along.y(), along.x());
  const Eigen::RowVectorXf u = along.transpose() * cloud;
  const Eigen::RowVectorXf v = across.transpose() * cloud;
  Rectangle rectangle;
  rectangle.yaw = yaw;
  rectangle.size = {u.maxCoeff() - u.minCoeff(), v.maxCoeff() - v.minCoeff()};
  rectangle.center =
      along * (u.maxCoeff() + u.minCoeff()) / 2.0F + across * (v.maxCoeff() + v.minCoeff()) / 2.0F;
  return rectangle;
}

Rectangle smallestRectangle(const Cloud2d& cloud) {
  Rectangle best;
  float best_area = std::numeric_limits<float>::infinity();
  for (int step = 0; step < kSteps; ++step) {
    const float yaw = kPi / 2.0F * static_cast<float>(step) / static_cast<float>(kSteps);
    const Rectangle rectangle = rectangleAt(cloud, yaw);
    // A line has no area in any direction: its half perimeter decides.
    const float area = rectangle.size.prod() + 1e-3F * rectangle.size.sum();
    if (area >= best_area) continue;
    best_area = area;
    best = rectangle;
  }
  if (best.size.x() < best.size.y()) {
    std::swap(best.size.x(), best.size.y());
    best.yaw += kPi / 2.0F;
  }
  return best;
}

}  // namespace

UprightBox fitBox(const std::vector<Point>& points, const std::vector<std::uint32_t>& indices) {
  UprightBox box;
  if (indices.empty()) return box;
  // Offsets from one point keep float exact far from the sensor.
  const Eigen::Vector3f origin = points[indices.front()].position();
  Cloud2d cloud(2, static_cast<Eigen::Index>(indices.size()));
  float low = origin.z();
  float high = origin.z();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const Eigen::Vector3f p = points[indices[k]].position();
    cloud.col(static_cast<Eigen::Index>(k)) = (p - origin).head<2>();
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  const Rectangle rectangle = smallestRectangle(cloud);
  box.center = {origin.x() + rectangle.center.x(), origin.y() + rectangle.center.y(),
                (low + high) / 2.0F};
  box.size = {rectangle.size.x(), rectangle.size.y(), high - low};
  box.yaw = rectangle.yaw;
  return box;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "support/box_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace segdf::test {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kSensorHeight = 1.73;
constexpr double kReach = 60.0;
constexpr int kBeams = 64;
constexpr double kTop = 2.0;
constexpr double kBottom = -24.8;

/// Distance along the ray to the box, infinite when missed (slab method).
double hit(const Box& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d low = box.center - box.size / 2.0;
  const Eigen::Vector3d high = box.center + box.size / 2.0;
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double inverse = 1.0 / direction[k];
    const double a = (low[k] - origin[k]) * inverse;
    const double b = (high[k] - origin[k]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave && enter > 0.0 ? enter : std::numeric_limits<double>::infinity();
}

Eigen::Vector3d rayDirection(int beam, int column, int columns) {
  const double elevation = (kTop + (kBottom - kTop) * beam / (kBeams - 1)) * kPi / 180.0;
  const double azimuth = 2.0 * kPi * (column + 0.5) / columns;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation)};
}

}  // namespace

std::size_t BoxWorld::add(
    double x, double y, double length, double width, double height, float intensity) {
  boxes_.push_back({{x, y, height / 2.0}, {length, width, height}, intensity});
  return boxes_.size() - 1;
}

void BoxWorld::moveTo(std::size_t box, double x, double y) {
  boxes_[box].center.x() = x;
  boxes_[box].center.y() = y;
}

Scan BoxWorld::scan(
    double x, double y, double heading_deg, std::int64_t stamp_ns, int columns) const {
  Scan scan;
  scan.stamp_ns = stamp_ns;
  scan.pose = Eigen::Translation3d(x, y, kSensorHeight) *
              Eigen::AngleAxisd(heading_deg * kPi / 180.0, Eigen::Vector3d::UnitZ());
  for (int beam = 0; beam < kBeams; ++beam) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector3d ray = rayDirection(beam, column, columns);
      const Eigen::Vector3d direction = scan.pose.linear() * ray;
      double range = direction.z() < 0.0 ? -kSensorHeight / direction.z() : kReach + 1.0;
      float intensity = 0.2F;
      for (const Box& box : boxes_) {
        const double to_box = hit(box, scan.pose.translation(), direction);
        if (to_box >= range) continue;
        range = to_box;
        intensity = box.intensity;
      }
      if (range > kReach) continue;
      const Eigen::Vector3f p = (ray * range).cast<float>();
      scan.points.push_back(
          {p.x(), p.y(), p.z(), intensity, 0.0F, static_cast<std::int16_t>(beam)});
    }
  }
  return scan;
}

BoxWorld makeStreet() {
  BoxWorld world;
  world.add(10.0, 12.0, 60.0, 1.0, 6.0);
  world.add(10.0, -12.0, 60.0, 1.0, 6.0);
  for (int k = 0; k < 5; ++k) world.add(-5.0 + 8.0 * k, 8.0, 0.3, 0.3, 4.0);
  return world;
}

std::vector<Point> randomBlob(const Eigen::Vector3d& center,
                              const Eigen::Vector3d& size,
                              std::size_t count,
                              std::uint32_t seed) {
  std::mt19937 generator(seed);
  const auto uniform = [&generator] {
    return static_cast<double>(generator()) / static_cast<double>(std::mt19937::max()) - 0.5;
  };
  std::vector<Point> points(count);
  for (Point& p : points) {
    p.x = static_cast<float>(center.x() + size.x() * uniform());
    p.y = static_cast<float>(center.y() + size.y() * uniform());
    p.z = static_cast<float>(center.z() + size.z() * uniform());
    p.intensity = 0.5F;
  }
  return points;
}

}  // namespace segdf::test

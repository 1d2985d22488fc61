// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace segdf {

namespace {

constexpr std::uint16_t kRoad = 40;
constexpr std::uint16_t kSidewalk = 48;
constexpr std::uint16_t kTerrain = 72;

}  // namespace

WayPoint interpolate(const std::vector<WayPoint>& path, double time) {
  const auto later = std::find_if(path.begin(), path.end(),
                                  [time](const WayPoint& point) { return point.time > time; });
  if (later == path.begin()) return path.front();
  if (later == path.end()) return path.back();
  const WayPoint& a = *(later - 1);
  const WayPoint& b = *later;
  const double share = (time - a.time) / (b.time - a.time);
  return {time, a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          a.yaw + share * std::remainder(b.yaw - a.yaw, 2.0 * 3.14159265358979323846)};
}

WayPoint SceneObject::at(double time) const { return interpolate(path, time); }

std::uint32_t SceneObject::label() const {
  const std::uint32_t semantic_class = moves() ? moving_class : standing_class;
  return (static_cast<std::uint32_t>(instance) << 16U) | semantic_class;
}

double StreetGround::heightAt(double x, double y) const {
  // Two long waves that do not repeat together within a drive.
  const double wave = 0.6 * std::sin(x / 11.0) + 0.4 * std::sin(x / 27.0 + y / 15.0);
  const double side = std::abs(y) > half_road ? kerb : 0.0;
  return undulation * wave + side;
}

std::uint16_t StreetGround::classAt(double y) const {
  if (std::abs(y) <= half_road) return kRoad;
  return std::abs(y) <= half_street ? kSidewalk : kTerrain;
}

Pose Scene::poseAt(const WayPoint& place) const {
  // The slope under the object, taken over a car's length, tilts it.
  constexpr double kHalfLength = 1.3;
  const double dx = kHalfLength * std::cos(place.yaw);
  const double dy = kHalfLength * std::sin(place.yaw);
  const double rise =
      ground.heightAt(place.x + dx, place.y + dy) - ground.heightAt(place.x - dx, place.y - dy);
  return Eigen::Translation3d(place.x, place.y, ground.heightAt(place.x, place.y)) *
         Eigen::AngleAxisd(place.yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-std::atan2(rise, 2.0 * kHalfLength), Eigen::Vector3d::UnitY());
}

}  // namespace segdf

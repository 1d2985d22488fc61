// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace segdf {

WayPoint interpolate(const std::vector<WayPoint>& path, double time) {
  const auto later =
      std::upper_bound(path.begin(), path.end(), time,
                       [](double t, const WayPoint& point) { return t < point.time; });
  if (later == path.begin()) return path.front();
  if (later == path.end()) return path.back();
  const WayPoint& a = *(later - 1);
  const WayPoint& b = *later;
  const double share = (time - a.time) / (b.time - a.time);
  return {time, a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          a.yaw + share * std::remainder(b.yaw - a.yaw, 2.0 * 3.14159265358979323846),
          a.way + share * (b.way - a.way)};
}

WayPoint SceneObject::at(double time) const { return interpolate(path, time); }

std::uint32_t SceneObject::label() const {
  const std::uint32_t semantic_class = moves() && moves_in_sight ? moving_class : standing_class;
  return (static_cast<std::uint32_t>(instance) << 16U) | semantic_class;
}

void settleSight(Scene& scene, double duration, double step) {
  constexpr double kSight = 60.0;    // metres
  constexpr double kMovement = 0.5;  // metres
  for (SceneObject& object : scene.objects) {
    if (!object.moves()) continue;
    std::optional<WayPoint> first;  // in sight
    object.moves_in_sight = false;
    for (double time = 0.0; time <= duration; time += step) {
      const WayPoint place = object.at(time);
      const WayPoint ego = interpolate(scene.ego, time);
      if (std::hypot(place.x - ego.x, place.y - ego.y) > kSight) continue;
      if (!first) first = place;
      const double gone = std::hypot(place.x - first->x, place.y - first->y);
      object.moves_in_sight = object.moves_in_sight || gone >= kMovement;
    }
  }
}

Pose Scene::poseAt(const WayPoint& place, double length, double width, bool upright) const {
  const Eigen::AngleAxisd turn(place.yaw, Eigen::Vector3d::UnitZ());
  if (upright) {
    return Eigen::Translation3d(place.x, place.y, ground.heightAt(place.x, place.y)) * turn;
  }
  // Axles stand at a third of the length from the middle, wheels close to the sides.
  const double fx = length / 3.0;
  const double fy = width / 2.5;
  const auto height = [&](double along, double across) {
    const Eigen::Vector3d foot = turn * Eigen::Vector3d(along, across, 0.0);
    return ground.heightAt(place.x + foot.x(), place.y + foot.y());
  };
  const double front = (height(fx, fy) + height(fx, -fy)) / 2.0;
  const double rear = (height(-fx, fy) + height(-fx, -fy)) / 2.0;
  const double left = (height(fx, fy) + height(-fx, fy)) / 2.0;
  const double right = (height(fx, -fy) + height(-fx, -fy)) / 2.0;
  return Eigen::Translation3d(place.x, place.y, (front + rear) / 2.0) * turn *
         Eigen::AngleAxisd(-std::atan2(front - rear, 2.0 * fx), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(std::atan2(left - right, 2.0 * fy), Eigen::Vector3d::UnitX());
}

Pose Scene::poseOf(const SceneObject& object, double time) const {
  return poseAt(object.at(time), object.length, object.width, object.upright);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/footprint.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace segdf {

namespace {

float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// One side of the hull over points in order of x: Andrew's monotone chain.
template <class Iterator>
std::vector<Eigen::Vector2f> chain(Iterator begin, Iterator end) {
  std::vector<Eigen::Vector2f> side;
  for (auto p = begin; p != end; ++p) {
    while (side.size() >= 2 &&
           cross(side.back() - side[side.size() - 2], *p - side.back()) <= 0.0F) {
      side.pop_back();
    }
    side.push_back(*p);
  }
  return side;
}

std::vector<Eigen::Vector2f> convexHull(std::vector<Eigen::Vector2f> points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
    return std::make_pair(a.x(), a.y()) < std::make_pair(b.x(), b.y());
  });
  std::vector<Eigen::Vector2f> hull = chain(points.begin(), points.end());
  const std::vector<Eigen::Vector2f> back = chain(points.rbegin(), points.rend());
  if (back.size() > 2) hull.insert(hull.end(), back.begin() + 1, back.end() - 1);
  return hull;
}

float squaredDistanceToEdge(const Eigen::Vector2f& x,
                            const Eigen::Vector2f& a,
                            const Eigen::Vector2f& b) {
  const Eigen::Vector2f edge = b - a;
  const float length = edge.squaredNorm();
  const float share = length > 0.0F ? std::clamp((x - a).dot(edge) / length, 0.0F, 1.0F) : 0.0F;
  return (x - a - share * edge).squaredNorm();
}

}  // namespace

Footprint::Footprint(std::vector<Eigen::Vector2f> points) : hull_(convexHull(std::move(points))) {
  for (const Eigen::Vector2f& corner : hull_) bounds_.extend(corner);
}

Eigen::AlignedBox2f Footprint::bounds(float margin) const {
  return {bounds_.min().array() - margin, bounds_.max().array() + margin};
}

bool Footprint::contains(const Eigen::Vector2f& place, float margin) const {
  if (!bounds(margin).contains(place)) return false;
  bool inside = hull_.size() > 2;
  for (std::size_t k = 0; k < hull_.size(); ++k) {
    const Eigen::Vector2f& a = hull_[k];
    const Eigen::Vector2f& b = hull_[(k + 1) % hull_.size()];
    if (squaredDistanceToEdge(place, a, b) <= margin * margin) return true;
    inside = inside && cross(b - a, place - a) >= 0.0F;
  }
  return inside;
}

bool Volume::contains(const Eigen::Vector3f& place, float margin) const {
  return place.z() >= bottom - margin && place.z() <= top + margin &&
         footprint.contains(place.head<2>(), margin);
}

Volume transformed(const Volume& volume, const Eigen::Isometry3f& to_T_from) {
  std::vector<Eigen::Vector2f> corners;
  Eigen::AlignedBox1f floor;
  for (const Eigen::Vector2f& corner : volume.footprint.corners()) {
    const Eigen::Vector3f low = to_T_from * Eigen::Vector3f(corner.x(), corner.y(), volume.bottom);
    corners.emplace_back(low.head<2>());
    floor.extend(low.tail<1>());
  }
  const float height = volume.top - volume.bottom;
  return {Footprint(std::move(corners)), floor.min().x(), floor.max().x() + height};
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/ground_rectangle.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>

namespace segdf {

namespace {

constexpr double kCell = 8.0;       // metres
constexpr double kLanePiece = 2.0;  // metres

Eigen::Vector2d axis(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }

/// Half the extent of the rectangle along a direction.
double halfExtent(const GroundRectangle& f, const Eigen::Vector2d& direction) {
  const Eigen::Vector2d along = axis(f.place.yaw);
  const Eigen::Vector2d across(-along.y(), along.x());
  return 0.5 *
         (f.length * std::abs(along.dot(direction)) + f.width * std::abs(across.dot(direction)));
}

}  // namespace

bool overlap(const GroundRectangle& a, const GroundRectangle& b) {
  const Eigen::Vector2d between(b.place.x - a.place.x, b.place.y - a.place.y);
  const Eigen::Vector2d u = axis(a.place.yaw);
  const Eigen::Vector2d v = axis(b.place.yaw);
  const std::array<Eigen::Vector2d, 4> axes{u, Eigen::Vector2d(-u.y(), u.x()), v,
                                            Eigen::Vector2d(-v.y(), v.x())};
  return std::all_of(axes.begin(), axes.end(), [&](const Eigen::Vector2d& direction) {
    return std::abs(between.dot(direction)) < halfExtent(a, direction) + halfExtent(b, direction);
  });
}

namespace {

template <class Visit>
bool anyCell(const GroundRectangle& f, const Visit& visit) {
  const double ex = halfExtent(f, Eigen::Vector2d::UnitX());
  const double ey = halfExtent(f, Eigen::Vector2d::UnitY());
  const auto cell = [](double value) { return static_cast<int>(std::floor(value / kCell)); };
  for (int i = cell(f.place.x - ex); i <= cell(f.place.x + ex); ++i) {
    for (int j = cell(f.place.y - ey); j <= cell(f.place.y + ey); ++j) {
      if (visit(std::pair{i, j})) return true;
    }
  }
  return false;
}

}  // namespace

void TakenGround::add(const GroundRectangle& footprint) {
  anyCell(footprint, [&](const Cell& cell) {
    cells_[cell].push_back(footprint);
    return false;
  });
}

void TakenGround::addLane(const Route& route, double way, const GroundRectangle& user) {
  for (double done = 0.0; done < way; done += kLanePiece) {
    add({route.at(done), std::max(user.length, kLanePiece + user.width), user.width});
  }
  add({route.at(way), user.length, user.width});
}

bool TakenGround::isFree(const GroundRectangle& footprint, double margin) const {
  GroundRectangle grown = footprint;
  grown.length += 2.0 * margin;
  grown.width += 2.0 * margin;
  return !anyCell(grown, [&](const Cell& cell) {
    const auto found = cells_.find(cell);
    return found != cells_.end() &&
           std::any_of(found->second.begin(), found->second.end(),
                       [&grown](const GroundRectangle& taken) { return overlap(grown, taken); });
  });
}

}  // namespace segdf

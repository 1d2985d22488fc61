// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace segdf {

namespace {

constexpr double kStep = 0.25;    // metres between places
constexpr double kLateral = 1.8;  // m/s^2 that a turn is taken with
constexpr double kBraking = 2.0;  // m/s^2
constexpr double kPi = 3.14159265358979323846;

Eigen::Vector2d vec(const StreetPoint& point) { return {point.along, point.across}; }

}  // namespace

Route::Route(const CentreLine& line, const std::vector<StreetPoint>& corners, double rounding) {
  Eigen::Vector2d from = vec(corners.front());
  addPoint(line, corners.front());
  const auto straight_to = [&](const Eigen::Vector2d& to) {
    const auto steps = static_cast<int>(std::ceil((to - from).norm() / kStep));
    for (int k = 1; k <= steps; ++k) {
      const Eigen::Vector2d p = from + (to - from) * k / steps;
      addPoint(line, {p.x(), p.y()});
    }
    from = to;
  };
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const Eigen::Vector2d corner = vec(corners[k]);
    const Eigen::Vector2d in = corner - vec(corners[k - 1]);
    const Eigen::Vector2d out = vec(corners[k + 1]) - corner;
    const double cut = std::min({rounding, in.norm() / 2.0, out.norm() / 2.0});
    const Eigen::Vector2d begin = corner - cut * in.normalized();
    const Eigen::Vector2d end = corner + cut * out.normalized();
    straight_to(begin);
    const auto steps = static_cast<int>(std::ceil(2.0 * cut / kStep));
    for (int i = 1; i <= steps; ++i) {
      const double u = static_cast<double>(i) / steps;
      const Eigen::Vector2d p =
          (1.0 - u) * (1.0 - u) * begin + 2.0 * u * (1.0 - u) * corner + u * u * end;
      addPoint(line, {p.x(), p.y()});
    }
    from = end;
  }
  straight_to(vec(corners.back()));
  setHeadings(line.place(corners.front()).yaw);
  setSpeeds();
}

void Route::addPoint(const CentreLine& line, const StreetPoint& point) {
  const Place place = line.place(point);
  double way = 0.0;
  if (!places_.empty()) {
    const double step = std::hypot(place.x - places_.back().x, place.y - places_.back().y);
    if (step < 1e-6) return;
    way = ways_.back() + step;
  }
  points_.push_back(point);
  places_.push_back(place);
  ways_.push_back(way);
}

void Route::setHeadings(double only_heading) {
  if (places_.size() == 1) places_.front().yaw = only_heading;
  for (std::size_t k = 0; k + 1 < places_.size(); ++k) {
    places_[k].yaw = std::atan2(places_[k + 1].y - places_[k].y, places_[k + 1].x - places_[k].x);
  }
  if (places_.size() > 1) places_.back().yaw = places_[places_.size() - 2].yaw;
}

void Route::setSpeeds() {
  const std::size_t n = places_.size();
  speeds_.assign(n, std::numeric_limits<double>::infinity());
  constexpr std::size_t kWindow = 4;  // places: a metre evens out the steps of the polyline
  for (std::size_t k = kWindow; k + kWindow < n; ++k) {
    const double turn =
        std::remainder(places_[k + kWindow].yaw - places_[k - kWindow].yaw, 2.0 * kPi);
    const double way = ways_[k + kWindow] - ways_[k - kWindow];
    if (turn != 0.0) speeds_[k] = std::sqrt(kLateral * way / std::abs(turn));
  }
  speeds_.back() = 0.0;
  for (std::size_t k = n - 1; k-- > 0;) {
    const double slower =
        std::sqrt(speeds_[k + 1] * speeds_[k + 1] + 2.0 * kBraking * (ways_[k + 1] - ways_[k]));
    speeds_[k] = std::min(speeds_[k], slower);
  }
}

std::size_t Route::indexAt(double way) const {
  const auto later = std::upper_bound(ways_.begin(), ways_.end(), way);
  return later == ways_.begin() ? 0 : static_cast<std::size_t>(later - ways_.begin()) - 1;
}

Place Route::at(double way) const {
  const std::size_t k = indexAt(way);
  if (k + 1 == places_.size()) return places_.back();
  const Place& a = places_[k];
  const Place& b = places_[k + 1];
  const double share = std::max(0.0, (way - ways_[k]) / (ways_[k + 1] - ways_[k]));
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          a.yaw + share * std::remainder(b.yaw - a.yaw, 2.0 * kPi)};
}

double Route::speedAt(double way) const { return speeds_[indexAt(way)]; }

double Route::wayWherePassed(double along, bool forward) const {
  const double sign = forward ? 1.0 : -1.0;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const double before = sign * (points_[k].along - along);
    const double after = sign * (points_[k + 1].along - along);
    if (before < 0.0 && after >= 0.0) return ways_[k];
  }
  return -1.0;
}

}  // namespace segdf

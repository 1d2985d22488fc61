// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/traffic.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace segdf {

namespace {

constexpr double kStep = 0.1;          // seconds
constexpr double kAcceleration = 1.8;  // m/s^2
constexpr double kBraking = 3.0;       // m/s^2
constexpr double kLook = 0.4;          // metres between the places looked at ahead
constexpr double kSideMargin = 0.3;    // metres that are left to what is passed
constexpr double kMoved = 0.05;        // metres: less is standing still
constexpr double kCreep = 0.05;        // metres to a stop that counts as reached
constexpr double kNever = std::numeric_limits<double>::infinity();

/// Speed from which a stop within `way` metres is possible.
double stopWithin(double way) { return std::sqrt(2.0 * kBraking * std::max(0.0, way)); }

class Traffic {
 public:
  Traffic(const std::vector<RoadUser>& users,
          const std::vector<Light>& lights,
          double stop_distance)
      : users_(users), lights_(lights) {
    for (const RoadUser& user : users) {
      State state;
      state.place = user.route.at(0.0);
      if (user.start <= 0.0) state.speed = std::min(user.speed, user.route.speedAt(0.0));
      for (const Light& light : lights) {
        const double forward = user.route.wayWherePassed(light.at - stop_distance, true);
        const double backward = user.route.wayWherePassed(light.at + stop_distance, false);
        state.stop_lines.push_back(user.obeys_lights ? std::max(forward, backward) : -1.0);
      }
      states_.push_back(std::move(state));
    }
  }

  void step(double time) {
    for (std::size_t i = 0; i < users_.size(); ++i) advance(i, time);
  }

  WayPoint wayPoint(std::size_t i, double time) const {
    const State& s = states_[i];
    return {time, s.place.x, s.place.y, s.place.yaw, s.way};
  }

 private:
  struct State {
    double way = 0.0;
    double speed = 0.0;
    Place place;
    std::size_t halts_done = 0;
    double waited = 0.0;             // seconds at the present halt
    std::vector<double> stop_lines;  // way of each light's stop line, negative: none
  };

  void advance(std::size_t i, double time) {
    const RoadUser& user = users_[i];
    State& state = states_[i];
    if (time < user.start || state.way >= user.route.length() - kCreep) {
      state.speed = 0.0;
      return;
    }
    double speed = std::min(user.speed, state.speed + kAcceleration * kStep);
    speed = std::min({speed, user.route.speedAt(state.way), haltLimit(i), lightLimit(i, time)});
    speed = std::min(speed, neighbourLimit(i));
    state.speed = speed;
    state.way = std::min(state.way + speed * kStep, user.route.length());
    state.place = user.route.at(state.way);
  }

  double haltLimit(std::size_t i) {
    const RoadUser& user = users_[i];
    State& state = states_[i];
    if (state.halts_done == user.halts.size()) return kNever;
    const Halt& halt = user.halts[state.halts_done];
    const double left = halt.at - state.way;
    if (left > kCreep) return std::min(stopWithin(left), left / kStep);
    state.waited += kStep;
    if (state.waited < halt.duration) return 0.0;
    state.waited = 0.0;
    ++state.halts_done;
    return kNever;
  }

  double lightLimit(std::size_t i, double time) const {
    const State& state = states_[i];
    double limit = kNever;
    for (std::size_t k = 0; k < lights_.size(); ++k) {
      const double left = state.stop_lines[k] - users_[i].length / 2.0 - state.way;
      const bool red = std::any_of(
          lights_[k].red.begin(), lights_[k].red.end(),
          [time](const auto& phase) { return time >= phase.first && time < phase.second; });
      // Who cannot stop any more drives on.
      if (!red || left < -kCreep || state.speed > stopWithin(left) + kBraking * kStep) continue;
      limit = std::min(limit, stopWithin(left - kCreep));
    }
    return limit;
  }

  /// By what stands or goes on the own way ahead.
  double neighbourLimit(std::size_t i) const {
    const RoadUser& user = users_[i];
    const State& state = states_[i];
    const bool vehicle = user.length > 2.5;
    const double gap = vehicle ? 2.0 : 0.5;
    const double look = state.speed * state.speed / (2.0 * kBraking) + gap + 1.0;
    double limit = kNever;
    for (std::size_t j = 0; j < users_.size(); ++j) {
      const double dx = states_[j].place.x - state.place.x;
      const double dy = states_[j].place.y - state.place.y;
      const double near = look + user.length + users_[j].length;
      if (j == i || dx * dx + dy * dy > near * near) continue;
      const double free = freeWay(i, j, look);
      if (free == kNever) continue;
      const double turn = states_[j].place.yaw - state.place.yaw;
      const double ahead = std::max(0.0, states_[j].speed * std::cos(turn));
      limit =
          std::min(limit, std::sqrt(ahead * ahead + 2.0 * kBraking * std::max(0.0, free - gap)));
    }
    return limit;
  }

  /// Metres from i's front to where its way meets the footprint of j.
  double freeWay(std::size_t i, std::size_t j, double look) const {
    const RoadUser& user = users_[i];
    const double front = user.length / 2.0;
    const double half_length = users_[j].length / 2.0 + 0.1;
    const double half_width = (users_[j].width + user.width) / 2.0 + kSideMargin;
    const Place& other = states_[j].place;
    const double c = std::cos(other.yaw);
    const double s = std::sin(other.yaw);
    // Begins within itself: a neighbour beside the own front is in the way as well.
    for (double way = front - 0.8; way <= front + look; way += kLook) {
      if (states_[i].way + way > user.route.length() + front) break;
      const Place place = user.route.at(states_[i].way + way);
      const double dx = place.x - other.x;
      const double dy = place.y - other.y;
      const double along = std::abs(c * dx + s * dy);
      const double across = std::abs(c * dy - s * dx);
      // Seen head-on or from behind, the widths count; from the side, length against width.
      const double turn = std::abs(std::sin(place.yaw - other.yaw));
      const double reach_along = half_length + turn * (user.width / 2.0 + kSideMargin);
      const double reach_across = half_width - turn * user.width / 2.0;
      if (along < reach_along && across < reach_across) return std::max(0.0, way - front);
    }
    return kNever;
  }

  const std::vector<RoadUser>& users_;
  const std::vector<Light>& lights_;
  std::vector<State> states_;
};

}  // namespace

std::vector<std::vector<WayPoint>> driveTogether(const std::vector<RoadUser>& users,
                                                 const std::vector<Light>& lights,
                                                 double stop_distance,
                                                 double duration) {
  Traffic traffic(users, lights, stop_distance);
  std::vector<std::vector<WayPoint>> paths(users.size());
  const auto steps = static_cast<int>(std::ceil(duration / kStep));
  for (int k = 0; k <= steps; ++k) {
    if (k > 0) traffic.step(k * kStep);
    for (std::size_t i = 0; i < users.size(); ++i) {
      paths[i].push_back(traffic.wayPoint(i, k * kStep));
    }
  }
  for (std::vector<WayPoint>& path : paths) {
    if (path.back().way < kMoved) path.resize(1);
  }
  return paths;
}

}  // namespace segdf

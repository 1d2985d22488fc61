// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "segdf/simulation/ground_rectangle.hpp"
#include "segdf/simulation/random.hpp"
#include "segdf/simulation/traffic.hpp"

#include "street_furniture.hpp"

namespace segdf {

namespace {

constexpr double kOwnLane = -1.75;
constexpr double kBehind = 70.0;      // metres of street before the start
constexpr double kAhead = 90.0;       // and after the end
constexpr double kStopLine = 9.0;     // metres from the middle of a crossing
constexpr double kOutOfSight = 95.0;  // metres: farther than any sensor's reach
// Streams of random numbers: what is said about one part of a scene does not change the others.
constexpr std::uint64_t kMoverStream = 1;
constexpr std::uint64_t kFlowStream = 2;
constexpr std::uint64_t kThingStream = 3;

double roundingOf(ObjectKind kind) {
  if (kind == ObjectKind::kPerson) return 0.5;
  return kind == ObjectKind::kCyclist ? 2.5 : 5.0;
}

class SceneBuilder {
 public:
  SceneBuilder(const SceneDescription& description, std::uint64_t seed, double duration)
      : description_(description), seed_(seed), duration_(duration) {
    const StreetDescription& street = description.street;
    Terrain& ground = scene_.ground;
    ground.line = CentreLine(street.bends);
    ground.grades = street.grades;
    ground.junctions = street.junctions;
    ground.undulation = street.undulation;
    ground.kerb = street.kerb;
    ground.begin = -kBehind - 40.0;
    ground.end = street.length + kAhead + 40.0;
  }

  Scene build() {
    addEgo();
    addThings();
    addMovers();
    addFlows();
    drive();
    furnishStreet(description_.street, -kBehind, description_.street.length + kAhead, seed_, taken_,
                  scene_);
    std::uint16_t instance = 0;
    for (SceneObject& object : scene_.objects) {
      if (object.moving_class != object.standing_class) object.instance = ++instance;
    }
    return std::move(scene_);
  }

 private:
  void addEgo() {
    const EgoDescription& ego = description_.ego;
    std::vector<StreetPoint> corners = ego.path;
    if (corners.empty()) corners = {{0.0, kOwnLane}, {description_.street.length, kOwnLane}};
    RoadUser user(Route(scene_.ground.line, corners, roundingOf(ObjectKind::kCar)));
    user.length = kEgoLength;
    user.width = kEgoWidth;
    user.speed = ego.speed;
    user.start = ego.start;
    user.halts = ego.halts;
    user.obeys_lights = true;
    users_.push_back(std::move(user));
  }

  void addThings() {
    Random random(seed_, kThingStream);
    for (const ThingDescription& thing : description_.things) {
      SceneObject object = makeObject(thing.kind, random, thing.size);
      const Place place = scene_.ground.line.place(thing.at);
      object.path = {{0.0, place.x, place.y, place.yaw + thing.heading, 0.0}};
      taken_.add({{place.x, place.y, place.yaw + thing.heading}, object.length, object.width});
      scene_.objects.push_back(std::move(object));
    }
  }

  void addUser(SceneObject object, RoadUser user) {
    user.length = object.length;
    user.width = object.width;
    users_.push_back(std::move(user));
    movers_.push_back(std::move(object));
  }

  void addMovers() {
    Random random(seed_, kMoverStream);
    for (const MoverDescription& mover : description_.movers) {
      RoadUser user(Route(scene_.ground.line, mover.path, roundingOf(mover.kind)));
      user.speed = mover.speed;
      user.start = mover.start;
      user.halts = mover.halts;
      user.obeys_lights = mover.lights && mover.kind != ObjectKind::kPerson;
      addUser(makeObject(mover.kind, random), std::move(user));
    }
  }

  GroundRectangle footprintOf(std::size_t user) const {
    return {users_[user].route.at(0.0), users_[user].length, users_[user].width};
  }

  void addFlows() {
    const std::size_t singles = users_.size();
    for (std::size_t k = 0; k < description_.flows.size(); ++k) {
      addFlow(description_.flows[k], Random(seed_, kFlowStream, k), singles);
    }
  }

  /// From the far end to where the last one starts that the street may see.
  void addFlow(const FlowDescription& flow, Random random, std::size_t singles) {
    const double way = flow.speed.high * duration_;
    const double sign = flow.forward ? 1.0 : -1.0;
    const double first = flow.forward ? scene_.ground.end : -scene_.ground.begin;
    const double last = (flow.forward ? scene_.ground.begin : -scene_.ground.end) - way;
    double front = first;
    while (front > last) {
      const auto draw =
          static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(flow.kinds.size())));
      const ObjectKind kind = flow.kinds[draw];
      SceneObject object = makeObject(kind, random);
      const double along = front - object.length / 2.0;
      front -= object.length + random.uniform(flow.gap.low, flow.gap.high);
      // Long enough for the whole drive, with room to brake at its end.
      const std::vector<StreetPoint> corners{{sign * along, flow.lane},
                                             {sign * (along + way + 50.0), flow.lane}};
      RoadUser user(Route(scene_.ground.line, corners, 0.0));
      user.speed = random.uniform(flow.speed.low, flow.speed.high);
      user.obeys_lights = flow.lights && kind != ObjectKind::kPerson;
      if (startsFree(user.route.at(0.0), object, singles)) {
        addUser(std::move(object), std::move(user));
      }
    }
  }

  /// Clear of those that a scene names one by one, and of what stands.
  bool startsFree(const Place& place, const SceneObject& object, std::size_t singles) const {
    const double margin = object.length > 2.5 ? 5.0 : 0.8;
    const GroundRectangle footprint{place, object.length + 2.0 * margin, object.width + 0.2};
    for (std::size_t k = 0; k < singles; ++k) {
      if (overlap(footprint, footprintOf(k))) return false;
    }
    return taken_.isFree({place, object.length, object.width}, 0.0);
  }

  void drive() {
    auto paths = driveTogether(users_, description_.street.lights, kStopLine, duration_);
    scene_.ego = paths.front();
    for (std::size_t k = 0; k < users_.size(); ++k) {
      taken_.addLane(users_[k].route, paths[k].back().way, footprintOf(k));
      if (k == 0 || !seen(paths[k])) continue;
      movers_[k - 1].path = std::move(paths[k]);
      scene_.objects.push_back(std::move(movers_[k - 1]));
    }
  }

  /// At any time near enough to the ego.
  bool seen(const std::vector<WayPoint>& path) const {
    for (std::size_t k = 0; k < scene_.ego.size(); ++k) {
      const WayPoint& other = path[std::min(k, path.size() - 1)];
      if (std::hypot(other.x - scene_.ego[k].x, other.y - scene_.ego[k].y) < kOutOfSight) {
        return true;
      }
    }
    return false;
  }

  const SceneDescription& description_;
  std::uint64_t seed_;
  double duration_;
  Scene scene_;
  TakenGround taken_;
  std::vector<RoadUser> users_;      // the ego first
  std::vector<SceneObject> movers_;  // users_[k + 1]
};

}  // namespace

Scene buildScene(const SceneDescription& description, std::uint64_t seed, double duration) {
  return SceneBuilder(description, seed, duration).build();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/street.hpp"

#include <cmath>
#include <utility>

#include "segdf/simulation/objects.hpp"
#include "segdf/simulation/random.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kOwnLane = -1.75;
constexpr double kOtherLane = 1.75;
constexpr double kParking = 5.7;      // |y| of parked cars
constexpr double kSidewalk = 9.5;     // |y| of people walking along
constexpr double kTreeLine = 8.2;     // |y| of trees and poles
constexpr double kGardenLine = 11.8;  // |y| of hedges and fences
constexpr double kHouseLine = 13.0;   // |y| of house fronts
constexpr double kBehind = 60.0;      // metres of street behind the start
constexpr double kAhead = 90.0;       // and beyond the end
// Every so often a side street opens between the houses.
constexpr double kJunctionEvery = 90.0;
constexpr double kFirstJunction = 45.0;
constexpr double kHalfJunction = 6.0;
constexpr double kGap = 2.0;  // seconds between oncoming vehicles

class StreetBuilder {
 public:
  explicit StreetBuilder(const StreetConfig& config) : config_(config), random_(config.seed) {
    scene_.ground.x_min = -kBehind - 40.0;
    scene_.ground.x_max = wayLength() + kAhead + 40.0;
  }

  Scene build() {
    scene_.ego = {{0.0, 0.0, kOwnLane, 0.0}, {config_.duration, wayLength(), kOwnLane, 0.0}};
    for (double side : {-1.0, 1.0}) {
      addHouses(side);
      addPlants(side);
      addParkedCars(side);
    }
    addCompanions();
    addOncoming();
    addCrossing();
    addPeople();
    return std::move(scene_);
  }

 private:
  double wayLength() const { return config_.duration * config_.speed; }
  double start() const { return -kBehind; }
  double end() const { return wayLength() + kAhead; }

  static bool inJunction(double x, double margin) {
    const double from = std::remainder(x - kFirstJunction, kJunctionEvery);
    return std::abs(from) < kHalfJunction + margin;
  }

  /// Things that can move have an identity; houses and plants have none.
  void add(SceneObject object, std::vector<WayPoint> path, bool with_identity = false) {
    object.path = std::move(path);
    if (with_identity) object.instance = ++last_instance_;
    scene_.objects.push_back(std::move(object));
  }

  /// A mover on a straight line through the whole drive, passing (x, y) at time t.
  void addMover(SceneObject object, double t, double x, double y, double yaw, double speed) {
    const double vx = speed * std::cos(yaw);
    const double vy = speed * std::sin(yaw);
    const double last = config_.duration;
    add(std::move(object),
        {{0.0, x - vx * t, y - vy * t, yaw}, {last, x + vx * (last - t), y + vy * (last - t), yaw}},
        true);
  }

  void addHouses(double side) {
    for (double x = start(); x < end();) {
      const double length = random_.uniform(9.0, 17.0);
      const double middle = x + length / 2.0;
      const double depth = random_.uniform(7.0, 10.0);
      if (!inJunction(middle, length / 2.0)) {
        add(makeHouse(random_, length, depth, random_.uniform(6.0, 11.0)),
            {{0.0, middle, side * (kHouseLine + depth / 2.0 + random_.uniform(0.0, 1.5)), 0.0}});
      }
      x += length + (random_.chance(0.4) ? random_.uniform(2.0, 6.0) : 0.3);
    }
  }

  void addPlants(double side) {
    for (double x = start(); x < end(); x += random_.uniform(7.0, 13.0)) {
      if (inJunction(x, 2.0)) continue;
      const WayPoint place{0.0, x, side * kTreeLine, 0.0};
      const double kind = random_.uniform();
      if (kind < 0.45) add(makeTree(random_), {place});
      if (kind >= 0.45 && kind < 0.75) add(makePole(random_), {place});
    }
    for (double x = start(); x < end(); x += random_.uniform(9.0, 20.0)) {
      const double length = random_.uniform(3.0, 7.0);
      if (inJunction(x, length)) continue;
      const WayPoint place{0.0, x, side * kGardenLine, 0.0};
      add(random_.chance(0.6) ? makeHedge(random_, length) : makeFence(random_, length), {place});
    }
  }

  void addParkedCars(double side) {
    for (double x = start(); x < end(); x += 4.8 + random_.uniform(0.4, 2.5)) {
      if (random_.chance(0.25) || inJunction(x, 4.0)) continue;
      const double turned = random_.chance(0.5) ? kPi : 0.0;
      add(makeCar(random_),
          {{0.0, x, side * (kParking + random_.uniform(-0.15, 0.15)),
            turned + random_.uniform(-0.03, 0.03)}},
          true);
    }
  }

  /// The hardest traffic: at the ego's own speed, always at the same distance.
  void addCompanions() {
    addMover(makeCar(random_), 0.0, random_.uniform(13.0, 18.0), kOwnLane, 0.0, config_.speed);
    addMover(makeCar(random_), 0.0, random_.uniform(-16.0, -11.0), kOwnLane, 0.0, config_.speed);
    addMover(makeCyclist(random_), 0.0, random_.uniform(10.0, 16.0), -4.0, 0.0, 4.0);
  }

  void addOncoming() {
    bool bus_came = false;
    for (double t = 1.0; t < config_.duration + 4.0; t += kGap + random_.uniform(0.0, 1.5)) {
      const bool bus = !bus_came && t > 0.3 * config_.duration;
      bus_came = bus_came || bus;
      // One speed for the whole lane: nobody drives through the one ahead.
      addMover(bus ? makeBus(random_) : makeCar(random_), t, t * config_.speed, kOtherLane, kPi,
               7.0);
      if (bus) t += kGap;
    }
  }

  /// One car crosses each junction three seconds before the ego gets there.
  void addCrossing() {
    for (double x = kFirstJunction; x < wayLength() + kAhead; x += kJunctionEvery) {
      const double t = x / config_.speed - 3.0;
      addMover(makeCar(random_), t, x - 2.0, 0.0, kPi / 2.0, 8.0);
    }
  }

  void addPeople() {
    for (double x = 5.0; x < wayLength() + 40.0; x += random_.uniform(12.0, 22.0)) {
      const double side = random_.chance(0.5) ? 1.0 : -1.0;
      const double y = side * (kSidewalk + random_.uniform(-0.8, 0.8));
      if (random_.chance(0.25)) {
        add(makePerson(random_), {{0.0, x, y, random_.uniform(-kPi, kPi)}}, true);
        continue;
      }
      const double yaw = random_.chance(0.5) ? 0.0 : kPi;
      addMover(makePerson(random_), 0.0, x, y, yaw, random_.uniform(1.0, 1.6));
    }
    // Across the street, well ahead of the ego.
    for (double x = 35.0; x < wayLength() + 30.0; x += 40.0) {
      const double t = x / config_.speed - 2.5;
      addMover(makePerson(random_), t, x, 0.0, kPi / 2.0, 1.4);
    }
  }

  StreetConfig config_;
  Random random_;
  Scene scene_;
  std::uint16_t last_instance_ = 0;
};

}  // namespace

Scene makeStreetScene(const StreetConfig& config) { return StreetBuilder(config).build(); }

}  // namespace segdf

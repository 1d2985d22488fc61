// SPDX-License-Identifier: BSD-3-Clause
#include "street_furniture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segdf/simulation/random.hpp"

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr std::uint64_t kFurnitureStream = 4;
// Metres from the centre line.
constexpr double kParking = 5.75;
constexpr double kKerbLine = 7.5;      // bollards, signs
constexpr double kTreeLine = 8.2;      // trees, poles
constexpr double kSidewalk = 10.9;     // people who stand
constexpr double kGardenLine = 12.0;   // hedges, fences
constexpr double kGarden = 13.2;       // trees and bushes from here ...
constexpr double kGardenDepth = 14.0;  // ... to this far behind, where no house stands
constexpr double kHouseLine = 15.0;    // house fronts
constexpr double kBackLine = 33.0;     // fronts of the row behind

class Furnisher {
 public:
  Furnisher(const StreetDescription& street,
            double begin,
            double end,
            std::uint64_t seed,
            TakenGround& taken,
            Scene& scene)
      : street_(street), begin_(begin), end_(end), seed_(seed), taken_(taken), scene_(scene) {}

  void furnish() {
    for (double side : {-1.0, 1.0}) {
      addHouses(side, kHouseLine, stream(side, 0));
      addHouses(side, kBackLine, stream(side, 11));
      addParked(side, stream(side, 1));
      scatter(ObjectKind::kTree, street_.trees, side * kTreeLine, 1.0, stream(side, 2));
      scatter(ObjectKind::kPole, street_.poles, side * kTreeLine, 1.0, stream(side, 3));
      scatter(ObjectKind::kSign, street_.signs, side * kKerbLine, 0.5, stream(side, 4));
      scatter(ObjectKind::kBollard, street_.bollards, side * kKerbLine, 0.5, stream(side, 5));
      scatter(ObjectKind::kHedge, street_.hedges, side * kGardenLine, 0.3, stream(side, 6));
      scatter(ObjectKind::kFence, street_.fences, side * kGardenLine, 0.3, stream(side, 7));
      scatter(ObjectKind::kPerson, street_.people, side * kSidewalk, 0.3, stream(side, 8));
      scatter(ObjectKind::kBush, street_.bushes, side * kGarden, 0.0, stream(side, 9));
      scatter(ObjectKind::kTree, street_.trees, side * kGarden, 0.3, stream(side, 10));
    }
  }

 private:
  Random stream(double side, std::uint64_t part) const {
    return Random(seed_, kFurnitureStream, 2 * part + (side > 0.0 ? 1 : 0));
  }

  /// False when the ground is taken.
  bool place(SceneObject object, const StreetPoint& at, double heading, double margin) {
    Place place = scene_.ground.line.place(at);
    place.yaw += heading;
    const GroundRectangle footprint{place, object.length, object.width};
    if (!taken_.isFree(footprint, margin)) return false;
    taken_.add(footprint);
    object.path = {{0.0, place.x, place.y, place.yaw, 0.0}};
    scene_.objects.push_back(std::move(object));
    return true;
  }

  void addHouses(double side, double front, Random random) {
    if (street_.houses <= 0.0) return;
    for (double along = begin_; along < end_;) {
      ObjectSize size;
      size.length = random.uniform(9.0, 17.0);
      size.depth = random.uniform(7.0, 10.0);
      size.height = random.uniform(5.0, 10.0);
      const double middle = along + size.length / 2.0;
      const double across = side * (front + size.depth / 2.0 + random.uniform(0.0, 1.5));
      SceneObject house = makeObject(ObjectKind::kHouse, random, size);
      const bool built = random.chance(street_.houses);
      if (built && !scene_.ground.inJunction(middle, size.length / 2.0 + 1.0) &&
          offTheStreet(middle, across, size)) {
        place(std::move(house), {middle, across}, 0.0, 0.05);
      }
      along += size.length + (random.chance(0.4) ? random.uniform(1.0, 5.0) : 0.2);
    }
  }

  /// A house beside one leg of a bent street must not stand on another one.
  bool offTheStreet(double along, double across, const ObjectSize& size) const {
    const double side = across > 0.0 ? 1.0 : -1.0;
    for (double x : {-0.5, 0.0, 0.5}) {
      for (double y : {-0.5, 0.5}) {
        const Place corner =
            scene_.ground.line.place({along + x * size.length, across + side * y * size.depth});
        const double distance = std::abs(scene_.ground.line.nearest(corner.x, corner.y).across);
        if (distance < scene_.ground.half_street + 0.5) return false;
      }
    }
    return true;
  }

  void addParked(double side, Random random) {
    if (street_.parked <= 0.0) return;
    double along = begin_;
    while (along < end_) {
      const ObjectKind kind = random.chance(0.1) ? ObjectKind::kVan : ObjectKind::kCar;
      SceneObject car = makeObject(kind, random);
      const double length = car.length;
      const double turned = random.chance(0.8) == (side < 0.0) ? 0.0 : kPi;
      const StreetPoint at{along + length / 2.0, side * (kParking + random.uniform(-0.1, 0.1))};
      const double heading = turned + random.uniform(-0.02, 0.02);
      if (random.chance(street_.parked) && !scene_.ground.inJunction(at.along, 6.0)) {
        place(std::move(car), at, heading, 0.1);
      }
      along += length + random.uniform(street_.parked_gap.low, street_.parked_gap.high);
    }
  }

  /// @param density per 100 m
  void scatter(ObjectKind kind, double density, double across, double margin, Random random) {
    const double side = across > 0.0 ? 1.0 : -1.0;
    const auto count = static_cast<int>(density * (end_ - begin_) / 100.0);
    for (int k = 0; k < count; ++k) {
      const double along = random.uniform(begin_, end_);
      ObjectSize size;
      size.length = random.uniform(3.0, 7.0);
      SceneObject object = makeObject(kind, random, size);
      const double depth = std::abs(across) == kGarden ? kGardenDepth : 0.4;
      const double heading = kind == ObjectKind::kPerson ? random.uniform(-kPi, kPi)
                             : kind == ObjectKind::kSign ? (side > 0.0 ? 0.0 : kPi)
                                                         : 0.0;
      const bool anywhere = kind == ObjectKind::kPerson || std::abs(across) == kGarden;
      const double aside = anywhere ? random.uniform(0.0, depth) : 0.0;
      if (scene_.ground.inJunction(along, object.length / 2.0 + 1.0)) continue;
      place(std::move(object), {along, across + side * aside}, heading, margin);
    }
  }

  const StreetDescription& street_;
  double begin_;
  double end_;
  std::uint64_t seed_;
  TakenGround& taken_;
  Scene& scene_;
};

}  // namespace

void furnishStreet(const StreetDescription& street,
                   double begin,
                   double end,
                   std::uint64_t seed,
                   TakenGround& taken,
                   Scene& scene) {
  Furnisher(street, begin, end, seed, taken, scene).furnish();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/objects.hpp"

#include <cmath>

#include "vehicles.hpp"

namespace segdf {

namespace {

using detail::box;
using detail::cylinder;
using detail::thing;

constexpr float kLeaves = 0.42F;
constexpr double kPi = 3.14159265358979323846;

/// Leaves scattered over an ellipsoid or, for a hedge, a bar: beams pass between them.
void addLeaves(SceneObject& plant,
               Random& random,
               const Eigen::Vector3d& center,
               const Eigen::Vector3d& half,
               int count,
               bool round) {
  for (int k = 0; k < count;) {
    const Eigen::Vector3d u(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                            random.uniform(-1.0, 1.0));
    if (round && u.norm() > 1.0) continue;
    Solid leaf = box(center + half.cwiseProduct(u),
                     Eigen::Vector3d::Constant(random.uniform(0.1, 0.28)), kLeaves);
    leaf.shape = Solid::Shape::kLeaf;
    leaf.yaw = random.uniform(0.0, 2.0 * kPi);
    plant.solids.push_back(leaf);
    ++k;
  }
}

Limb leg(double side, double hip, double diameter, float clothes, double phase) {
  Limb limb;
  limb.solids.push_back(cylinder({0.0, side, hip / 2.0}, diameter, hip, clothes));
  limb.pivot = hip;
  limb.phase = phase;
  return limb;
}

SceneObject makePerson(Random& random) {
  SceneObject person = thing(30, 254, 0.6, 0.55);
  person.upright = true;
  const double height = random.uniform(1.55, 1.9);
  const auto clothes = static_cast<float>(random.uniform(0.1, 0.5));
  const auto trousers = static_cast<float>(random.uniform(0.1, 0.4));
  const double hip = 0.47 * height;
  const double phase = random.uniform(0.0, 2.0 * kPi);
  person.limbs.push_back(leg(0.1, hip, 0.15, trousers, phase));
  person.limbs.push_back(leg(-0.1, hip, 0.15, trousers, phase + kPi));
  for (double side : {-0.26, 0.26}) {
    Limb arm = leg(side, 0.0, 0.0, clothes, phase + (side > 0.0 ? kPi : 0.0));
    arm.solids = {cylinder({0.0, side, 0.62 * height}, 0.1, 0.38 * height, clothes)};
    arm.pivot = 0.81 * height;
    person.limbs.push_back(arm);
  }
  person.solids.push_back(
      box({0.0, 0.0, hip + 0.18 * height}, {0.24, 0.4, 0.36 * height}, clothes));
  person.solids.push_back(cylinder({0.0, 0.0, 0.92 * height}, 0.18, 0.16 * height, 0.4F));
  return person;
}

SceneObject makeCyclist(Random& random) {
  SceneObject cyclist = thing(31, 253, 1.8, 0.6);
  const auto clothes = static_cast<float>(random.uniform(0.1, 0.5));
  for (double x : {-0.52, 0.52}) {
    cyclist.solids.push_back(detail::wheel({x, 0.0, 0.34}, 0.68, 0.05, 0.12F));
  }
  cyclist.solids.push_back(box({0.0, 0.0, 0.55}, {1.0, 0.05, 0.06}, 0.3F));
  cyclist.solids.push_back(box({0.1, 0.0, 0.8}, {0.6, 0.05, 0.06}, 0.3F));
  cyclist.solids.push_back(box({0.42, 0.0, 1.0}, {0.06, 0.5, 0.06}, 0.3F));
  const double phase = random.uniform(0.0, 2.0 * kPi);
  for (double side : {-0.12, 0.12}) {
    Limb limb = leg(side, 0.95, 0.15, clothes, phase + (side > 0.0 ? kPi : 0.0));
    limb.solids = {cylinder({-0.05, side, 0.6}, 0.15, 0.7, clothes)};
    limb.cycle = 5.0;  // metres a turn of the pedals
    cyclist.limbs.push_back(limb);
  }
  cyclist.solids.push_back(box({0.0, 0.0, 1.25}, {0.35, 0.42, 0.6}, clothes));
  cyclist.solids.push_back(cylinder({0.1, 0.0, 1.66}, 0.2, 0.25, 0.4F));
  return cyclist;
}

SceneObject makeTree(Random& random) {
  const double diameter = random.uniform(0.25, 0.5);
  SceneObject tree = thing(70, 70, diameter, diameter);
  tree.upright = true;
  const double trunk = random.uniform(2.2, 3.2);
  const double radius = random.uniform(1.5, 2.6);
  tree.solids.push_back(cylinder({0.0, 0.0, trunk / 2.0 + 0.5}, diameter, trunk + 1.2, 0.25F));
  const int leaves = static_cast<int>(150.0 * radius * radius);
  addLeaves(tree, random, {0.0, 0.0, trunk + 0.8 * radius}, {radius, radius, radius}, leaves, true);
  return tree;
}

SceneObject makeBush(Random& random) {
  const double radius = random.uniform(0.5, 1.3);
  SceneObject bush = thing(70, 70, 2.0 * radius, 2.0 * radius);
  const double half = random.uniform(0.5, 1.2);
  const int leaves = static_cast<int>(360.0 * radius * half);
  addLeaves(bush, random, {0.0, 0.0, half}, {radius, radius, half}, leaves, true);
  return bush;
}

SceneObject makePole(Random& random) {
  const double diameter = random.uniform(0.12, 0.2);
  SceneObject pole = thing(80, 80, diameter, diameter);
  pole.upright = true;
  const double height = random.uniform(4.5, 7.5);
  pole.solids.push_back(cylinder({0.0, 0.0, height / 2.0 - 0.1}, diameter, height + 0.2, 0.4F));
  return pole;
}

SceneObject makeSign(Random& random) {
  SceneObject sign = thing(81, 81, 0.1, 0.6);
  sign.upright = true;
  const double height = random.uniform(2.1, 2.6);
  sign.solids.push_back(cylinder({0.0, 0.0, height / 2.0 - 0.1}, 0.07, height + 0.2, 0.4F));
  sign.solids.push_back(box({0.05, 0.0, height - 0.3}, {0.02, 0.6, 0.6}, detail::kRetro));
  return sign;
}

SceneObject makeBollard() {
  SceneObject bollard = thing(80, 80, 0.15, 0.15);
  bollard.upright = true;
  bollard.solids.push_back(cylinder({0.0, 0.0, 0.4}, 0.12, 1.0, 0.3F));
  bollard.solids.push_back(cylinder({0.0, 0.0, 0.8}, 0.125, 0.08, detail::kRetro));
  return bollard;
}

SceneObject makeHouse(Random& random, const ObjectSize& size) {
  SceneObject house = thing(50, 50, size.length, size.depth);
  house.upright = true;
  const auto wall = static_cast<float>(random.uniform(0.35, 0.6));
  // Two metres of foundation: on a slope no gap shows.
  house.solids.push_back(
      box({0.0, 0.0, size.height / 2.0 - 1.0}, {size.length, size.depth, size.height + 2.0}, wall));
  Solid roof = box({0.0, 0.0, size.height + 1.2}, {size.length, size.depth, 2.4}, 0.25F);
  roof.taper = {1.0, 0.1};
  house.solids.push_back(roof);
  // Window sills and a door frame give the wall some relief, as real ones have.
  for (double x = -size.length / 2.0 + 1.5; x < size.length / 2.0 - 1.0; x += 2.5) {
    for (double z : {1.0, 3.8}) {
      house.solids.push_back(box({x, 0.0, z}, {1.2, size.depth + 0.3, 0.12}, 0.45F));
    }
  }
  return house;
}

SceneObject makeWall(const ObjectSize& size) {
  SceneObject wall = thing(50, 50, size.length, 0.3);
  wall.upright = true;
  wall.solids.push_back(
      box({0.0, 0.0, size.height / 2.0 - 1.0}, {size.length, 0.3, size.height + 2.0}, 0.4F));
  return wall;
}

SceneObject makeHedge(Random& random, const ObjectSize& size) {
  SceneObject hedge = thing(70, 70, size.length, 0.8);
  const double height = random.uniform(0.8, 1.5);
  const int count = static_cast<int>(140.0 * size.length * height);
  addLeaves(hedge, random, {0.0, 0.0, height / 2.0}, {size.length / 2.0, 0.3, height / 2.0}, count,
            false);
  return hedge;
}

SceneObject makeFence(Random& random, const ObjectSize& size) {
  SceneObject fence = thing(51, 51, size.length, 0.1);
  const double height = random.uniform(1.0, 1.4);
  for (double x = -size.length / 2.0; x <= size.length / 2.0; x += 0.22) {
    fence.solids.push_back(box({x, 0.0, height / 2.0}, {0.1, 0.03, height}, 0.35F));
  }
  for (double z : {0.3, height - 0.1}) {
    fence.solids.push_back(box({0.0, 0.03, z}, {size.length, 0.03, 0.1}, 0.35F));
  }
  return fence;
}

}  // namespace

bool canMove(ObjectKind kind) { return kind <= ObjectKind::kCyclist; }

SceneObject makeObject(ObjectKind kind, Random& random, const ObjectSize& size) {
  switch (kind) {
    case ObjectKind::kCar:
      return detail::makeCar(random);
    case ObjectKind::kVan:
      return detail::makeVan(random);
    case ObjectKind::kBus:
      return detail::makeBus(random);
    case ObjectKind::kTruck:
      return detail::makeTruck(random);
    case ObjectKind::kPerson:
      return makePerson(random);
    case ObjectKind::kCyclist:
      return makeCyclist(random);
    case ObjectKind::kTree:
      return makeTree(random);
    case ObjectKind::kBush:
      return makeBush(random);
    case ObjectKind::kPole:
      return makePole(random);
    case ObjectKind::kSign:
      return makeSign(random);
    case ObjectKind::kBollard:
      return makeBollard();
    case ObjectKind::kHedge:
      return makeHedge(random, size);
    case ObjectKind::kFence:
      return makeFence(random, size);
    case ObjectKind::kWall:
      return makeWall(size);
    case ObjectKind::kHouse:
      break;
  }
  return makeHouse(random, size);
}

}  // namespace segdf

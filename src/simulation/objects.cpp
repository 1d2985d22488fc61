// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/objects.hpp"

#include <cmath>

namespace segdf {

namespace {

constexpr float kGlass = 0.1F;
constexpr float kTyre = 0.06F;
constexpr float kRetro = 1.5F;
constexpr float kLeaves = 0.36F;

SceneObject thing(std::uint16_t standing_class, std::uint16_t moving_class) {
  SceneObject object;
  object.standing_class = standing_class;
  object.moving_class = moving_class;
  return object;
}

Solid box(const Eigen::Vector3d& center, const Eigen::Vector3d& size, float reflectance) {
  Solid solid;
  solid.center = center;
  solid.size = size;
  solid.reflectance = reflectance;
  return solid;
}

Solid cylinder(const Eigen::Vector3d& center, double diameter, double height, float reflectance) {
  Solid solid = box(center, {diameter, diameter, height}, reflectance);
  solid.shape = Solid::Shape::kCylinder;
  return solid;
}

float paint(Random& random) { return static_cast<float>(random.uniform(0.05, 0.4)); }

void addWheels(SceneObject& car, double length, double width) {
  for (double x : {-0.3 * length, 0.3 * length}) {
    for (double y : {-0.5 * width + 0.12, 0.5 * width - 0.12}) {
      car.solids.push_back(box({x, y, 0.3}, {0.6, 0.2, 0.6}, kTyre));
    }
  }
}

/// Lights and plates shine back from front and rear.
void addPlates(SceneObject& car, double length, double width) {
  for (double x : {-0.5 * length - 0.01, 0.5 * length + 0.01}) {
    car.solids.push_back(box({x, 0.0, 0.55}, {0.02, 0.5, 0.12}, kRetro));
    for (double y : {-0.38 * width, 0.38 * width}) {
      car.solids.push_back(box({x, y, 0.75}, {0.02, 0.25, 0.15}, kRetro));
    }
  }
}

/// Small boxes scattered over an ellipsoid or, for a hedge, a bar.
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
                     Eigen::Vector3d::Constant(random.uniform(0.08, 0.22)), kLeaves);
    leaf.yaw = random.uniform(0.0, 3.14);
    plant.solids.push_back(leaf);
    ++k;
  }
}

}  // namespace

SceneObject makeCar(Random& random) {
  SceneObject car = thing(10, 252);
  const double length = random.uniform(3.7, 4.8);
  const double width = random.uniform(1.65, 1.9);
  const double height = random.uniform(1.4, 1.65);
  const float colour = paint(random);
  car.solids.push_back(box({0.0, 0.0, 0.58}, {length, width, 0.72}, colour));
  car.solids.push_back(box({-0.06 * length, 0.0, 0.5 * (0.94 + height)},
                           {0.5 * length, 0.86 * width, height - 0.94}, colour));
  for (double side : {-1.0, 1.0}) {
    Solid window = box({-0.06 * length, side * 0.432 * width, 0.5 * (0.96 + height)},
                       {0.44 * length, 0.02, 0.7 * (height - 0.94)}, kGlass);
    window.glass = true;
    car.solids.push_back(window);
  }
  addWheels(car, length, width);
  addPlates(car, length, width);
  return car;
}

SceneObject makeBus(Random& random) {
  SceneObject bus = thing(13, 257);
  const float colour = paint(random);
  bus.solids.push_back(box({0.0, 0.0, 0.85}, {11.5, 2.5, 1.1}, colour));
  bus.solids.push_back(box({0.0, 0.0, 2.75}, {11.5, 2.5, 0.6}, colour));
  Solid windows = box({0.0, 0.0, 1.92}, {11.46, 2.46, 1.06}, kGlass);
  windows.glass = true;
  bus.solids.push_back(windows);
  for (double x : {-5.4, -2.5, 0.0, 2.5, 5.4}) {
    for (double y : {-1.2, 1.2}) {
      bus.solids.push_back(box({x, y, 1.92}, {0.25, 0.1, 1.06}, colour));
    }
  }
  addWheels(bus, 11.5, 2.5);
  addPlates(bus, 11.5, 2.5);
  return bus;
}

SceneObject makePerson(Random& random) {
  SceneObject person = thing(30, 254);
  const double height = random.uniform(1.6, 1.9);
  const double stride = random.uniform(0.1, 0.25);
  const auto clothes = static_cast<float>(random.uniform(0.1, 0.5));
  const double hip = 0.47 * height;
  person.solids.push_back(cylinder({stride, 0.09, hip / 2.0}, 0.14, hip, clothes));
  person.solids.push_back(cylinder({-stride, -0.09, hip / 2.0}, 0.14, hip, clothes));
  person.solids.push_back(
      box({0.0, 0.0, hip + 0.19 * height}, {0.24, 0.44, 0.38 * height}, clothes));
  person.solids.push_back(cylinder({0.0, 0.0, 0.925 * height}, 0.18, 0.15 * height, 0.4F));
  return person;
}

SceneObject makeCyclist(Random& random) {
  SceneObject cyclist = thing(31, 253);
  const auto clothes = static_cast<float>(random.uniform(0.1, 0.5));
  for (double x : {-0.52, 0.52}) {
    cyclist.solids.push_back(box({x, 0.0, 0.34}, {0.6, 0.05, 0.62}, 0.15F));
  }
  cyclist.solids.push_back(box({0.0, 0.0, 0.55}, {1.0, 0.05, 0.06}, 0.3F));
  cyclist.solids.push_back(box({0.35, 0.0, 1.0}, {0.06, 0.5, 0.06}, 0.3F));
  cyclist.solids.push_back(cylinder({0.05, 0.0, 0.7}, 0.24, 0.6, clothes));
  cyclist.solids.push_back(box({0.0, 0.0, 1.25}, {0.35, 0.42, 0.6}, clothes));
  cyclist.solids.push_back(cylinder({0.1, 0.0, 1.66}, 0.2, 0.25, 0.4F));
  return cyclist;
}

SceneObject makeTree(Random& random) {
  SceneObject tree = thing(70, 70);
  const double trunk = random.uniform(2.0, 2.8);
  const double radius = random.uniform(1.3, 2.0);
  tree.solids.push_back(
      cylinder({0.0, 0.0, trunk / 2.0}, random.uniform(0.25, 0.45), trunk, 0.25F));
  addLeaves(tree, random, {0.0, 0.0, trunk + 0.8 * radius}, {radius, radius, radius}, 260, true);
  return tree;
}

SceneObject makePole(Random& random) {
  SceneObject pole = thing(80, 80);
  const double height = random.uniform(4.5, 7.0);
  pole.solids.push_back(
      cylinder({0.0, 0.0, height / 2.0}, random.uniform(0.12, 0.2), height, 0.4F));
  return pole;
}

SceneObject makeHouse(Random& random, double length, double depth, double height) {
  SceneObject house = thing(50, 50);
  const auto wall = static_cast<float>(random.uniform(0.3, 0.5));
  house.solids.push_back(box({0.0, 0.0, height / 2.0 - 0.5}, {length, depth, height + 1.0}, wall));
  // Window sills and a door frame give the wall some relief, as real ones have.
  for (double x = -length / 2.0 + 1.5; x < length / 2.0 - 1.0; x += 2.5) {
    for (double z : {1.0, 3.8}) {
      house.solids.push_back(box({x, 0.0, z}, {1.2, depth + 0.3, 0.12}, 0.45F));
    }
  }
  return house;
}

SceneObject makeHedge(Random& random, double length) {
  SceneObject hedge = thing(70, 70);
  const double height = random.uniform(0.8, 1.5);
  const int count = static_cast<int>(90.0 * length * height);
  addLeaves(hedge, random, {0.0, 0.0, height / 2.0}, {length / 2.0, 0.3, height / 2.0}, count,
            false);
  return hedge;
}

SceneObject makeFence(Random& random, double length) {
  SceneObject fence = thing(51, 51);
  const double height = random.uniform(1.0, 1.4);
  for (double x = -length / 2.0; x <= length / 2.0; x += 0.22) {
    fence.solids.push_back(box({x, 0.0, height / 2.0}, {0.1, 0.03, height}, 0.35F));
  }
  for (double z : {0.3, height - 0.1}) {
    fence.solids.push_back(box({0.0, 0.03, z}, {length, 0.03, 0.1}, 0.35F));
  }
  return fence;
}

}  // namespace segdf

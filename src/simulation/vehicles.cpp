// SPDX-License-Identifier: BSD-3-Clause
#include "vehicles.hpp"

namespace segdf::detail {

namespace {

float paint(Random& random) { return static_cast<float>(random.uniform(0.04, 0.3)); }

Solid glass(const Eigen::Vector3d& center, const Eigen::Vector3d& size) {
  Solid pane = box(center, size, kGlass);
  pane.glass = true;
  return pane;
}

struct Axle {
  double x = 0.0;         ///< metres
  double diameter = 0.6;  ///< metres
};

void addAxle(SceneObject& car, const Axle& axle) {
  for (double side : {-1.0, 1.0}) {
    const double y = side * (0.5 * car.width - 0.12);
    car.solids.push_back(wheel({axle.x, y, axle.diameter / 2.0}, axle.diameter, 0.22, kTyre));
  }
}

/// Lights and plates shine back from front and rear.
void addPlates(SceneObject& car) {
  for (double x : {-0.5 * car.length - 0.01, 0.5 * car.length + 0.01}) {
    car.solids.push_back(box({x, 0.0, 0.55}, {0.02, 0.5, 0.12}, kRetro));
    for (double y : {-0.38 * car.width, 0.38 * car.width}) {
      car.solids.push_back(box({x, y, 0.75}, {0.02, 0.25, 0.15}, kRetro));
    }
  }
}

/// Windows all around, narrower at the roof, with seats to be seen through them.
struct Cabin {
  double rear = -2.0;   ///< x, metres
  double front = 1.0;   ///< x, metres
  double sill = 0.95;   ///< lower edge of the windows, metres
  double roof = 1.5;    ///< metres
  double taper = 0.68;  ///< length of the roof relative to the sill's
};

void addCabin(SceneObject& car, const Cabin& cabin, float colour) {
  const double length = cabin.front - cabin.rear;
  const double x = (cabin.front + cabin.rear) / 2.0;
  const double width = 0.94 * car.width;
  const double glazed = cabin.roof - 0.05 - cabin.sill;
  Solid windows = glass({x, 0.0, cabin.sill + glazed / 2.0}, {length, width, glazed});
  windows.taper = {cabin.taper, 0.82};
  car.solids.push_back(windows);
  const double top = 0.82 * width;
  car.solids.push_back(box({x, 0.0, cabin.roof - 0.03}, {cabin.taper * length, top, 0.06}, colour));
  for (double side : {-1.0, 1.0}) {
    const Solid pillar =
        box({x, side * 0.45 * width, cabin.sill + glazed / 2.0}, {0.12, 0.06, glazed}, colour);
    car.solids.push_back(pillar);
    car.solids.push_back(
        box({x + 0.1 * length, side * 0.22 * width, cabin.sill + 0.1}, {0.2, 0.45, 0.45}, 0.15F));
  }
  car.solids.push_back(box({x - 0.22 * length, 0.0, cabin.sill + 0.1}, {0.2, 1.2, 0.4}, 0.15F));
}

}  // namespace

SceneObject thing(std::uint16_t standing_class,
                  std::uint16_t moving_class,
                  double length,
                  double width) {
  SceneObject object;
  object.standing_class = standing_class;
  object.moving_class = moving_class;
  object.length = length;
  object.width = width;
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

Solid wheel(const Eigen::Vector3d& center, double diameter, double width, float reflectance) {
  Solid solid = box(center, {diameter, diameter, width}, reflectance);
  solid.shape = Solid::Shape::kWheel;
  return solid;
}

SceneObject makeCar(Random& random) {
  SceneObject car = thing(10, 252, random.uniform(3.7, 4.8), random.uniform(1.65, 1.9));
  const double height = random.uniform(1.4, 1.7);
  const double half = car.length / 2.0;
  const bool estate = random.chance(0.5);
  const float colour = paint(random);
  Solid body = box({0.0, 0.0, 0.6}, {car.length, car.width, 0.7}, colour);
  body.taper = {0.96, 0.94};
  car.solids.push_back(body);
  addCabin(car, {estate ? -0.95 * half : -0.7 * half, 0.5 * half, 0.95, height, 0.7}, colour);
  addAxle(car, {-0.62 * half, 0.62});
  addAxle(car, {0.6 * half, 0.62});
  addPlates(car);
  return car;
}

SceneObject makeVan(Random& random) {
  SceneObject van = thing(20, 259, random.uniform(4.8, 5.5), random.uniform(1.9, 2.05));
  const double height = random.uniform(1.9, 2.4);
  const double half = van.length / 2.0;
  const float colour = paint(random);
  van.solids.push_back(box({0.0, 0.0, 0.65}, {van.length, van.width, 0.8}, colour));
  van.solids.push_back(box({-0.3 * half, 0.0, 0.5 * (1.05 + height)},
                           {1.4 * half, 0.96 * van.width, height - 1.05}, colour));
  addCabin(van, {0.4 * half, 0.88 * half, 1.05, height, 0.6}, colour);
  addAxle(van, {-0.58 * half, 0.68});
  addAxle(van, {0.62 * half, 0.68});
  addPlates(van);
  return van;
}

SceneObject makeBus(Random& random) {
  SceneObject bus = thing(13, 257, 11.5, 2.5);
  const float colour = paint(random);
  bus.solids.push_back(box({0.0, 0.0, 0.85}, {11.5, 2.5, 1.1}, colour));
  bus.solids.push_back(box({0.0, 0.0, 2.75}, {11.5, 2.5, 0.6}, colour));
  bus.solids.push_back(glass({0.0, 0.0, 1.92}, {11.46, 2.46, 1.06}));
  for (double x : {-5.4, -2.5, 0.0, 2.5, 5.4}) {
    for (double y : {-1.2, 1.2}) {
      bus.solids.push_back(box({x, y, 1.92}, {0.25, 0.1, 1.06}, colour));
    }
  }
  for (double x = -4.8; x < 4.5; x += 0.8) {
    bus.solids.push_back(box({x, 0.8, 1.5}, {0.15, 0.6, 0.6}, 0.15F));
    bus.solids.push_back(box({x, -0.8, 1.5}, {0.15, 0.6, 0.6}, 0.15F));
  }
  addAxle(bus, {-3.4, 0.95});
  addAxle(bus, {3.2, 0.95});
  addPlates(bus);
  return bus;
}

SceneObject makeTruck(Random& random) {
  SceneObject truck = thing(18, 258, random.uniform(7.5, 9.5), 2.45);
  const double half = truck.length / 2.0;
  const double roof = random.uniform(3.2, 3.7);
  const float colour = paint(random);
  truck.solids.push_back(box({0.0, 0.0, 0.85}, {truck.length - 0.6, 0.9, 0.25}, 0.12F));  // frame
  truck.solids.push_back(box({half - 1.0, 0.0, 1.1}, {2.0, 2.4, 1.3}, colour));
  addCabin(truck, {half - 1.9, half, 1.75, 2.7, 0.85}, colour);
  const double bed = truck.length - 2.4;
  truck.solids.push_back(box({-half + bed / 2.0, 0.0, 0.5 * (1.05 + roof)},
                             {bed, 2.45, roof - 1.05},
                             static_cast<float>(random.uniform(0.2, 0.5))));
  addAxle(truck, {half - 1.3, 0.95});
  addAxle(truck, {-half + 1.8, 0.95});
  addPlates(truck);
  return truck;
}

}  // namespace segdf::detail

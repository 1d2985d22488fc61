// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "segdf/simulation/random.hpp"
#include "segdf/simulation/scene.hpp"

/// Parts of the object builders.
namespace segdf::detail {

constexpr float kGlass = 0.1F;
constexpr float kTyre = 0.06F;
constexpr float kRetro = 1.5F;

/// An object without parts. @param length along x, @param width along y; metres
SceneObject thing(std::uint16_t standing_class,
                  std::uint16_t moving_class,
                  double length,
                  double width);
Solid box(const Eigen::Vector3d& center, const Eigen::Vector3d& size, float reflectance);
Solid cylinder(const Eigen::Vector3d& center, double diameter, double height, float reflectance);
Solid wheel(const Eigen::Vector3d& center, double diameter, double width, float reflectance);

SceneObject makeCar(Random& random);
SceneObject makeVan(Random& random);
SceneObject makeBus(Random& random);
/// With a gap between road and load bed.
SceneObject makeTruck(Random& random);

}  // namespace segdf::detail

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/simulation/random.hpp"
#include "segdf/simulation/scene.hpp"

namespace segdf {

// Builders of the things in a street, each with its foot at the origin and its front along x. Sizes
// are those of method.md 5.4 with some scatter; path and instance are left to the caller.

SceneObject makeCar(Random& random);
SceneObject makeBus(Random& random);
SceneObject makePerson(Random& random);
SceneObject makeCyclist(Random& random);
/// Trunk and a crown of small boxes, through which some beams pass.
SceneObject makeTree(Random& random);
SceneObject makePole(Random& random);
/// @param length along x, @param depth along y, @param height; metres
SceneObject makeHouse(Random& random, double length, double depth, double height);
/// A row of small boxes, 0.6 m thick. @param length along x, metres
SceneObject makeHedge(Random& random, double length);
/// Posts and slats with gaps. @param length along x, metres
SceneObject makeFence(Random& random, double length);

}  // namespace segdf

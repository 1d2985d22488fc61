// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "segdf/simulation/random.hpp"
#include "segdf/simulation/scene.hpp"

namespace segdf {

/// What can stand or move in a scene.
enum class ObjectKind : std::uint8_t {
  kCar,
  kVan,
  kBus,
  kTruck,
  kPerson,
  kCyclist,
  kTree,
  kBush,
  kPole,
  kSign,
  kBollard,
  kHedge,
  kFence,
  kWall,
  kHouse,
};

/// Sizes to choose; what a kind leaves to chance ignores them. Metres.
struct ObjectSize {
  double length = 5.0;  ///< along x: hedge, fence, wall, house
  double depth = 8.0;   ///< along y: house
  double height = 6.0;  ///< wall, house
};

/// A thing with its foot at the origin and its front along x. Sizes are those of method.md 5.4 with
/// some scatter; path and instance are left to the caller.
SceneObject makeObject(ObjectKind kind, Random& random, const ObjectSize& size = {});

/// Vehicles, people and cyclists: what can move, and has an identity.
bool canMove(ObjectKind kind);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "segdf/simulation/scene.hpp"

namespace segdf {

/// How long and how fast the drive along the street is.
struct StreetConfig {
  std::uint64_t seed = 1;
  double duration = 10.0;  ///< seconds
  double speed = 8.0;      ///< of the ego vehicle along +x, m/s
};

/// A street with houses, trees, poles, hedges, fences and parked cars on both sides, a junction,
/// and on it: a car ahead and one behind at the ego's speed, oncoming cars and a bus, one that
/// crosses, a cyclist, and people who walk along, cross, and stand. Traffic comes as long as the
/// drive lasts.
Scene makeStreetScene(const StreetConfig& config);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "segdf/simulation/ground_rectangle.hpp"
#include "segdf/simulation/scene.hpp"
#include "segdf/simulation/scene_description.hpp"

namespace segdf {

/// Adds houses, plants, poles, parked cars and people who stand, by chance and only where the
/// ground is free. @param begin, @param end metres along
void furnishStreet(const StreetDescription& street,
                   double begin,
                   double end,
                   std::uint64_t seed,
                   TakenGround& taken,
                   Scene& scene);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "segdf/simulation/scene.hpp"
#include "segdf/simulation/scene_description.hpp"

namespace segdf {

/// GroundRectangle of the ego vehicle, metres.
constexpr double kEgoLength = 4.4;
constexpr double kEgoWidth = 1.8;

/// Builds the scene that a description and a seed stand for: sets up what is named, lets all that
/// moves drive together for `duration` seconds, and fills the street by chance where nothing stands
/// and nobody passes. The same arguments give the same scene.
Scene buildScene(const SceneDescription& description, std::uint64_t seed, double duration);

}  // namespace segdf

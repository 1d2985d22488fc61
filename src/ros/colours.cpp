// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/colours.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {
namespace {

constexpr Colour kRemoved{230, 25, 25};
constexpr Colour kGround{120, 120, 120};
constexpr Colour kNoInstance{180, 180, 180};
constexpr Colour kUnjudged{70, 70, 70};

// Hues from 60 (yellow) to 300 degrees (violet): nothing that looks like the red of what was
// removed.
constexpr double kFirstHue = 60.0;
constexpr double kHueRange = 240.0;
// Multiples of the golden ratio, modulo 1, never come close to each other soon.
constexpr double kGoldenRatio = 0.618033988749895;

/// Fully saturated colour of a hue in degrees: each channel is a trapezium over the circle.
std::uint8_t channel(double hue, double centre) {
  const double distance = std::abs(std::remainder(hue - centre, 360.0));
  return static_cast<std::uint8_t>(255.0 * std::clamp(2.0 - distance / 60.0, 0.0, 1.0));
}

Colour instanceColour(std::uint32_t instance) {
  const double hue = kFirstHue + kHueRange * std::fmod(instance * kGoldenRatio, 1.0);
  return {channel(hue, 0.0), channel(hue, 120.0), channel(hue, 240.0)};
}

}  // namespace

Colour colourOf(std::uint32_t semantic_class, std::uint32_t instance) {
  if (semantic_class == semantic_kitti::kDynamic) return kRemoved;
  if (semantic_class == semantic_kitti::kRoad) return kGround;
  if (semantic_class == semantic_kitti::kUnlabelled) return kUnjudged;
  return instance == 0 ? kNoInstance : instanceColour(instance);
}

std::uint32_t pack(Colour colour) {
  return std::uint32_t{colour.r} << 16U | std::uint32_t{colour.g} << 8U | colour.b;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace segdf {

struct Colour {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

/// Red is kept for what was removed, grey for ground and for points without instance; instances get
/// colours of their own, far apart for neighbouring ids.
/// @param semantic_class SemanticKITTI-style class @param instance id, 0 = none
Colour colourOf(std::uint32_t semantic_class, std::uint32_t instance);

/// 0x00RRGGBB, as the field `rgb` holds it (bit for bit in a float32).
std::uint32_t pack(Colour colour);

}  // namespace segdf

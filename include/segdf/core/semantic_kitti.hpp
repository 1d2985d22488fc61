// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/label.hpp"

/// SemanticKITTI's label coding: class in the lower, instance in the upper 16 bits.
namespace segdf::semantic_kitti {

// Classes that segdf writes itself; ground truth uses more of them.
constexpr std::uint16_t kUnlabelled = 0;
constexpr std::uint16_t kStatic = 9;  ///< segdf: static, no finer class
constexpr std::uint16_t kCar = 10;    ///< segdf: static high-mobility instance
constexpr std::uint16_t kRoad = 40;   ///< segdf: ground
constexpr std::uint16_t kBuilding = 50;
constexpr std::uint16_t kVegetation = 70;
constexpr std::uint16_t kDynamic = 251;  ///< segdf: removed; not used by SemanticKITTI itself
constexpr std::uint16_t kFirstMoving = 252;
constexpr std::uint16_t kLastMoving = 259;

/// Class in the lower 16 bits.
constexpr std::uint16_t classOf(std::uint32_t label) {
  return static_cast<std::uint16_t>(label & 0xFFFFU);
}

/// Instance in the upper 16 bits, 0 = none.
constexpr std::uint16_t instanceOf(std::uint32_t label) {
  return static_cast<std::uint16_t>(label >> 16U);
}

/// Ground truth: 252..259.
constexpr bool isMoving(std::uint16_t semantic_class) {
  return semantic_class >= kFirstMoving && semantic_class <= kLastMoving;
}

/// Ground truth: 0 (unlabelled) and 1 (outlier) are not scored.
constexpr bool isIgnored(std::uint16_t semantic_class) { return semantic_class <= 1; }

/// Ground truth: 10 11 13 15 16 18 20 30 31 32, classes that can move, standing still.
bool isParkedMovable(std::uint16_t semantic_class);

/// Ground truth: 40 44 48 49 60 72, what one drives and walks on.
bool isGround(std::uint16_t semantic_class);

/// A global instance id as labels hold it: 1 to 65535, after which they begin anew at 1; 0 = none.
std::uint16_t shortId(std::uint32_t instance);

/// Codes a verdict as in docs: 0, 9, 10, 40, 50, 70 or 251, with the shortId() of its instance; the
/// map and instances.csv keep ids whole.
std::uint32_t encode(const PointLabel& label);

/// Makes the kept points of an instance dynamic. @param labels of a scan, as encode() makes them
/// @return how many there were
std::size_t revoke(std::vector<std::uint32_t>& labels, std::uint32_t instance);

}  // namespace segdf::semantic_kitti

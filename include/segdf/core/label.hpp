// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace segdf {

/// What the filter says of one point. Every input point gets exactly one of them.
enum class PointState : std::uint8_t {
  kUnjudged,  ///< outside the method's range, in the ego box, not finite, or in a scan not mapped
  kGround,    ///< ground (draft III-B), always static
  kStatic,    ///< part of a static instance
  kDynamic,   ///< part of a dynamic instance: removed from the map
  kNoise,     ///< cluster too small to be an instance; kept in the map
};

/// The draft's low-level semantics (III-C); kNone for points that are in no instance.
enum class ObjectClass : std::uint8_t { kNone, kVegetation, kBuilding, kHighMobility, kUnknown };

/// Verdict on one input point.
struct PointLabel {
  std::uint32_t instance = 0;  ///< global instance id, 0 = in no instance
  PointState state = PointState::kUnjudged;
  ObjectClass object_class = ObjectClass::kNone;

  friend bool operator==(const PointLabel& a, const PointLabel& b) {
    return a.instance == b.instance && a.state == b.state && a.object_class == b.object_class;
  }
  friend bool operator!=(const PointLabel& a, const PointLabel& b) { return !(a == b); }
};

/// True iff a point with this state belongs into the static map.
constexpr bool isKept(PointState state) {
  return state == PointState::kGround || state == PointState::kStatic ||
         state == PointState::kNoise;
}

/// Lower-case name: "none", "vegetation", "building", "high_mobility", "unknown".
std::string toString(ObjectClass object_class);

/// Lower-case name: "unjudged", "ground", "static", "dynamic", "noise".
std::string toString(PointState state);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/label.hpp"

namespace segdf {

std::string toString(ObjectClass object_class) {
  switch (object_class) {
    case ObjectClass::kVegetation:
      return "vegetation";
    case ObjectClass::kBuilding:
      return "building";
    case ObjectClass::kHighMobility:
      return "high_mobility";
    case ObjectClass::kUnknown:
      return "unknown";
    case ObjectClass::kNone:
      break;
  }
  return "none";
}

std::string toString(PointState state) {
  switch (state) {
    case PointState::kGround:
      return "ground";
    case PointState::kStatic:
      return "static";
    case PointState::kDynamic:
      return "dynamic";
    case PointState::kNoise:
      return "noise";
    case PointState::kUnjudged:
      break;
  }
  return "unjudged";
}

}  // namespace segdf

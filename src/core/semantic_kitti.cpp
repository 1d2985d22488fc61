// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/semantic_kitti.hpp"

#include <algorithm>
#include <array>

namespace segdf::semantic_kitti {

namespace {

constexpr std::uint32_t kMaxInstance = 0xFFFF;

std::uint16_t semanticClass(const PointLabel& label) {
  switch (label.state) {
    case PointState::kUnjudged:
      return kUnlabelled;
    case PointState::kGround:
      return kRoad;
    case PointState::kDynamic:
      return kDynamic;
    case PointState::kNoise:
      return kStatic;
    case PointState::kStatic:
      break;
  }
  switch (label.object_class) {
    case ObjectClass::kVegetation:
      return kVegetation;
    case ObjectClass::kBuilding:
      return kBuilding;
    case ObjectClass::kHighMobility:
      return kCar;
    case ObjectClass::kUnknown:
    case ObjectClass::kNone:
      break;
  }
  return kStatic;
}

}  // namespace

bool isParkedMovable(std::uint16_t semantic_class) {
  constexpr std::array<std::uint16_t, 10> kMovable{10, 11, 13, 15, 16, 18, 20, 30, 31, 32};
  return std::find(kMovable.begin(), kMovable.end(), semantic_class) != kMovable.end();
}

bool isGround(std::uint16_t semantic_class) {
  constexpr std::array<std::uint16_t, 6> kGround{40, 44, 48, 49, 60, 72};
  return std::find(kGround.begin(), kGround.end(), semantic_class) != kGround.end();
}

std::uint16_t shortId(std::uint32_t instance) {
  if (instance == 0) return 0;
  return static_cast<std::uint16_t>((instance - 1) % kMaxInstance + 1);
}

std::uint32_t encode(const PointLabel& label) {
  return (std::uint32_t{shortId(label.instance)} << 16U) | semanticClass(label);
}

std::size_t revoke(std::vector<std::uint32_t>& labels, std::uint32_t instance) {
  std::size_t count = 0;
  for (std::uint32_t& label : labels) {
    if (instanceOf(label) != shortId(instance) || classOf(label) == kDynamic) continue;
    label = (label & ~std::uint32_t{0xFFFF}) | kDynamic;
    ++count;
  }
  return count;
}

}  // namespace segdf::semantic_kitti

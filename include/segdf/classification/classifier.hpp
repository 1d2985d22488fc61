// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "segdf/core/config.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// The rules of method.md 5.4, first hit wins: what the draft (III-C) calls vegetation, buildings
/// and high mobility, and unknown for what cannot be told apart by shape.
ObjectClass classify(const FeatureVector& features, std::size_t points, const ClassConfig& config);

/// True for the classes that Algorithm 2 tests for motion.
constexpr bool isTested(ObjectClass object_class) {
  return object_class == ObjectClass::kHighMobility || object_class == ObjectClass::kUnknown;
}

}  // namespace segdf

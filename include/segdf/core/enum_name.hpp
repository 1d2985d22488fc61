// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace segdf {

/// Pairs an enumerator with its name in YAML.
template <class Enum>
struct EnumName {
  Enum value;
  const char* name;
};

/// YAML name of an enumerator.
template <class Enum, std::size_t N>
const char* nameOf(Enum value, const std::array<EnumName<Enum>, N>& names) {
  for (const EnumName<Enum>& entry : names) {
    if (entry.value == value) return entry.name;
  }
  return "";
}

}  // namespace segdf

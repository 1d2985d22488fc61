// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/tally.hpp"

namespace segdf {
namespace {

bool isPowerOfTen(std::size_t value) {
  while (value >= 10 && value % 10 == 0) value /= 10;
  return value == 1;
}

}  // namespace

bool Tally::count(const std::string& kind) { return isPowerOfTen(++counts_[kind]); }

std::size_t Tally::of(const std::string& kind) const {
  const auto found = counts_.find(kind);
  return found == counts_.end() ? 0 : found->second;
}

}  // namespace segdf

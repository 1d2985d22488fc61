// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace segdf {

/// Disjoint sets over 0..n-1 whose root is always the smallest member, whatever the order of
/// unions.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }

  /// @returns the common root
  std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return a;
  }

  /// Makes it a set of its own. To be done to all members of a set.
  void isolate(std::uint32_t x) { parent_[x] = x; }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace segdf {

/// Numbers the occupied voxels of a grid 0, 1, 2, ... in the order in which they are first named.
/// Open addressing; nothing depends on the order of the table.
class VoxelIndex {
 public:
  static constexpr std::int32_t kNone = -1;

  /// @param edge of a voxel, metres
  explicit VoxelIndex(float edge) : inverse_edge_(1.0F / edge), slots_(kFirstSlots) {}

  std::size_t size() const { return count_; }

  /// Voxel of a place, the same for all places in it.
  std::uint64_t keyOf(const Eigen::Vector3f& place) const {
    std::uint64_t key = 0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto cell = static_cast<std::int64_t>(std::floor(place[k] * inverse_edge_)) + kOffset;
      key = (key << 21U) | (static_cast<std::uint64_t>(cell) & ((std::uint64_t{1} << 21U) - 1U));
    }
    return key;
  }

  /// Number of a voxel, kNone when no place in it was ever inserted.
  std::int32_t find(std::uint64_t key) const { return slots_[slotOf(key)].number; }

  /// Number of the voxel of a place; a new one gets the next number.
  std::int32_t insert(const Eigen::Vector3f& place) {
    const std::uint64_t key = keyOf(place);
    if (key == last_.key && last_.number != kNone) return last_.number;
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slots_[slotOf(key)];
    if (slot.number == kNone) slot = {key, static_cast<std::int32_t>(count_++)};
    last_ = slot;
    return slot.number;
  }

 private:
  static constexpr std::size_t kFirstSlots = 4096;  // a power of two, like all later sizes
  static constexpr std::int64_t kOffset = std::int64_t{1} << 20U;  // makes 21-bit cells positive

  struct Slot {
    std::uint64_t key = 0;
    std::int32_t number = kNone;
  };

  /// The key's slot, or the empty one where it would go.
  std::size_t slotOf(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 32U) & mask;
    while (slots_[slot].number != kNone && slots_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    const std::vector<Slot> old = std::move(slots_);
    slots_.assign(2 * old.size(), Slot{});
    for (const Slot& slot : old) {
      if (slot.number != kNone) slots_[slotOf(slot.key)] = slot;
    }
  }

  float inverse_edge_;
  std::size_t count_ = 0;
  std::vector<Slot> slots_;
  Slot last_;  // inserted: a scan's points come side by side
};

}  // namespace segdf

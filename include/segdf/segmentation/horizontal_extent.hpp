// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

namespace segdf {

/// Extent of points in the horizontal plane along directions 15 degrees apart: length and width of
/// what they belong to, whichever way it faces, good to 4 %.
class HorizontalExtent {
 public:
  HorizontalExtent();

  void add(float x, float y);
  /// Adds all points of another one.
  void add(const HorizontalExtent& other);
  /// True when the point is no farther out than `margin` metres in any of the directions.
  bool contains(float x, float y, float margin) const;
  /// Greatest extent, metres.
  float length() const { return extent(longest()); }
  /// Extent across the greatest one, metres.
  float width() const { return extent((longest() + kDirections / 2) % kDirections); }

 private:
  static constexpr std::size_t kDirections = 12;

  static float alongAxis(std::size_t direction, float x, float y);
  float extent(std::size_t direction) const { return high_[direction] - low_[direction]; }
  std::size_t longest() const;

  std::array<float, kDirections> low_;
  std::array<float, kDirections> high_;
};

}  // namespace segdf

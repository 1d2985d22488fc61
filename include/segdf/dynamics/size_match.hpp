// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace segdf {

/// May a thing of size `part` be seen of one of size `whole` (length, width, height; metres)? From
/// afar, or from behind others, a part is seen. Views of one object differ by 30 % and 0.3 m.
inline bool isPartOf(const Eigen::Vector3f& part, const Eigen::Vector3f& whole) {
  return (part.array() <= 1.3F * whole.array() + 0.3F).all();
}

/// May both be views of one object?
inline bool isSameSize(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return isPartOf(a, b) && isPartOf(b, a);
}

/// May a thing of this size move? Nothing is longer than an articulated bus.
inline bool isMoverSized(const Eigen::Vector3f& size) {
  constexpr float kLongest = 19.0F;  // metres
  constexpr float kHighest = 4.5F;   // metres
  return size.x() <= kLongest && size.z() <= kHighest;
}

}  // namespace segdf

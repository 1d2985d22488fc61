// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace segdf {

/// The greatest size (length, width, height; metres) that another view of a thing of this size may
/// have: views of one object differ by 30 % and 0.3 m.
inline Eigen::Vector3f greatestView(const Eigen::Vector3f& size) {
  return 1.3F * size + Eigen::Vector3f::Constant(0.3F);
}

/// May a thing of size `part` be seen of one of size `whole`? From afar, or from behind others, a
/// part is seen.
inline bool isPartOf(const Eigen::Vector3f& part, const Eigen::Vector3f& whole) {
  return (part.array() <= greatestView(whole).array()).all();
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

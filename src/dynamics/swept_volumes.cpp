// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/swept_volumes.hpp"

#include <algorithm>

#include "segdf/dynamics/frame_segments.hpp"

namespace segdf {

namespace {

void tell(const KeyFrame& from, KeyFrame& to) {
  const Eigen::Isometry3f to_T_from = (to.scan.pose.inverse() * from.scan.pose).cast<float>();
  for (const Volume& volume : from.moving) to.swept.push_back(transformed(volume, to_T_from));
}

}  // namespace

void exchangeSweptVolumes(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  frame.moving = dynamicVolumes(frame);
  for (std::size_t k = position - std::min(position, kFramesAround); k < position; ++k) {
    tell(frame, *window[k]);
    tell(*window[k], frame);
  }
}

}  // namespace segdf

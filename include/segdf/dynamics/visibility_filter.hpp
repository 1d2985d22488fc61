// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/dynamic_filter.hpp"
#include "segdf/dynamics/place_memory.hpp"
#include "segdf/dynamics/track_vote.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// Algorithm 2 by visibility (method.md 6.4 to 6.8, 6.12): each key frame is compared, in both
/// directions of time, with others at several times and ways; an instance is dynamic when enough of
/// them saw through the place where it was. Decisions are made when a frame leaves the window, with
/// all the evidence that it will get.
class VisibilityFilter : public DynamicFilter {
 public:
  VisibilityFilter(const Config& config, IdSource& ids, int threads);

  bool isSettled(const Window& window) const override;
  void observe(const Window& window) override;
  void decide(const Window& window, std::size_t position) override;
  void settle(KeyFrame& frame) const override;
  std::vector<Revocation> takeRevocations() override { return places_.takeRevocations(); }

 private:
  void compare(const Window& window);
  void judge(KeyFrame& frame) const;
  /// Is what stood in earlier frames looked after?
  bool remembers() const {
    return config_.df.left_looks > 0 && config_.df.semi_static == SemiStatic::kRemove;
  }

  Config config_;
  CurvedGrid grid_;
  IdSource& ids_;
  TrackBook tracks_;
  PlaceMemory places_;
  int threads_;
};

}  // namespace segdf

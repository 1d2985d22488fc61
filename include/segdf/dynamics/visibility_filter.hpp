// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/consensus.hpp"
#include "segdf/dynamics/departure.hpp"
#include "segdf/dynamics/dynamic_filter.hpp"
#include "segdf/dynamics/place_memory.hpp"
#include "segdf/dynamics/track_vote.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// Algorithm 2 by visibility (method.md 6.4 to 6.8, 6.12): each key frame is compared, in both
/// directions of time, with others at several times and ways; an instance is dynamic when enough of
/// them saw through the place where it was. A frame is judged when it has all the evidence that it
/// will get, and leaves the window when those that the consensus asks have been judged, too.
class VisibilityFilter : public DynamicFilter {
 public:
  VisibilityFilter(const Config& config, IdSource& ids, int threads);

  bool isSettled(const Window& window) const override;
  void observe(const Window& window) override;
  void decide(const Window& window, std::size_t count) override;
  void settle(KeyFrame& frame) const override;
  std::vector<Revocation> takeRevocations() override { return places_.takeRevocations(); }

 private:
  /// The newest frame with older ones. @return pairs whose poses fit
  std::vector<ComparedPair> compare(const Window& window);
  /// By its own evidence, and by what is known of its tracks.
  void judge(const Window& window, std::size_t position);
  void judgeByVotes(KeyFrame& frame) const;
  void finish(KeyFrame& frame);
  /// Does what moves at any time go from where it stands, too?
  bool removesParked() const { return config_.df.semi_static == SemiStatic::kRemove; }
  /// Is what stood in earlier frames looked after?
  bool remembers() const { return config_.df.left_looks > 0 && removesParked(); }

  Config config_;
  CurvedGrid grid_;
  IdSource& ids_;
  TrackBook tracks_;
  Consensus consensus_;
  PlaceMemory places_;
  int threads_;
};

}  // namespace segdf

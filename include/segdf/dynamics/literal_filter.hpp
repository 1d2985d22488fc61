// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/classification/features.hpp"
#include "segdf/core/config.hpp"
#include "segdf/dynamics/association.hpp"
#include "segdf/dynamics/dynamic_filter.hpp"

namespace segdf {

/// Algorithm 2 as printed (method.md 6.2), on pairs of consecutive key frames (k-1, k): an instance
/// of k-1 of a tested class is
///   HD, dynamic, when no segment of k is near any of its voxels (lines 9-10);
///   HS, static, when one is and occupancy is at least threOccu (lines 11-12);
///   split, when occupancy is less: the part not found again is dynamic (lines 13-15);
///   HS and fuse, when several are and occupancy is enough (lines 16-18).
/// The last frame is judged against the one before it. Of the four cases HS and Fuse also carry
/// instance ids from k-1 to k.
class LiteralFilter : public DynamicFilter {
 public:
  LiteralFilter(const Config& config, IdSource& ids, int threads);

  bool isSettled(const Window& window) const override { return window.size() > 2; }
  void observe(const Window& window) override;
  void decide(const Window& window, std::size_t count) override;
  void settle(KeyFrame& /*frame*/) const override {}
  std::vector<Revocation> takeRevocations() override { return {}; }

 private:
  void judge(KeyFrame& frame, const std::vector<SegmentOverlap>& overlaps);
  void judgeInstance(KeyFrame& frame, std::size_t segment, const SegmentOverlap& overlap);
  void split(KeyFrame& frame, std::size_t segment, const std::vector<std::uint32_t>& lost);

  Config config_;
  CurvedGrid grid_;
  IdSource& ids_;
  int threads_;
};

}  // namespace segdf

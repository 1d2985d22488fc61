// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/erasor_protocol.hpp"

#include <cmath>

#include "segdf/core/parallel.hpp"
#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

namespace {

constexpr double kTransferReach = 0.6;  // metres
// Near points are found in the first cells; few points have their nearest neighbour further away.
constexpr double kTransferCell = 0.1;  // metres

}  // namespace

std::optional<double> VoxelScores::rejectionRate() const {
  const auto remaining = remaining_dynamic.percent();
  if (!remaining) return std::nullopt;
  return 100.0 - *remaining;
}

std::optional<double> VoxelScores::f1() const {
  const auto pr = preservationRate();
  const auto rr = rejectionRate();
  if (!pr || !rr) return std::nullopt;
  return *pr + *rr > 0.0 ? 0.01 * 2.0 * *pr * *rr / (*pr + *rr) : 0.0;
}

bool VoxelMapBuilder::takes(const Eigen::Vector3f& in_sensor) {
  // A NaN coordinate compares false and is left out.
  return in_sensor.allFinite() && in_sensor.head<2>().cast<double>().norm() >= kMinRange;
}

VoxelScores compareVoxelMaps(const ClassedPoints& truth, const ClassedPoints& estimate) {
  const double limit = 0.5 * std::sqrt(3.0) * VoxelMapBuilder::kLeaf;
  const PointGrid grid(estimate.points, VoxelMapBuilder::kLeaf);
  VoxelScores scores;
  for (std::size_t g = 0; g < truth.points.size(); ++g) {
    const bool dynamic = semantic_kitti::isMoving(truth.classes[g]);
    const auto nearest = grid.nearest(truth.points[g], limit);
    const bool inlier = nearest && nearest->distance < limit &&
                        semantic_kitti::isMoving(estimate.classes[nearest->index]) == dynamic;
    (dynamic ? scores.remaining_dynamic : scores.preserved).count(inlier);
  }
  return scores;
}

ClassedPoints transferClasses(const ClassedPoints& truth,
                              const std::vector<Eigen::Vector3f>& map,
                              int threads) {
  constexpr std::size_t kGrain = 4096;
  const PointGrid grid(truth.points, kTransferCell);
  ClassedPoints labelled{map, std::vector<std::uint16_t>(map.size(), semantic_kitti::kUnlabelled)};
  parallelBlocks(map.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto nearest = grid.nearest(map[i], kTransferReach);
      if (nearest) labelled.classes[i] = truth.classes[nearest->index];
    }
  });
  return labelled;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/map_overlap.hpp"

#include "segdf/evaluation/point_grid.hpp"

namespace segdf {

namespace {

constexpr double kNear = 0.25;            // metres: more than half the diagonal of a 0.2 m voxel
constexpr std::size_t kEnough = 4000000;  // map points: more only take time
constexpr int kSteps = 30;     // of 0.1 m, up and down: a sensor stands no higher than 3 m
constexpr double kStep = 0.1;  // metres

double shareNear(const std::vector<Eigen::Vector3f>& truth, const PointGrid& map, double raise) {
  if (truth.empty()) return 0.0;
  std::size_t near = 0;
  for (const Eigen::Vector3f& point : truth) {
    const Eigen::Vector3f lowered = point - Eigen::Vector3f(0.0F, 0.0F, static_cast<float>(raise));
    near += map.hasWithin(lowered, kNear) ? 1 : 0;
  }
  return static_cast<double>(near) / static_cast<double>(truth.size());
}

}  // namespace

MapOverlap measureOverlap(const std::vector<Eigen::Vector3f>& truth,
                          const std::vector<Eigen::Vector3f>& map) {
  std::vector<Eigen::Vector3f> thinned;
  const std::size_t every = map.size() / kEnough + 1;
  for (std::size_t i = 0; i < map.size(); i += every) thinned.push_back(map[i]);
  const PointGrid grid(thinned, kNear);
  MapOverlap overlap;
  overlap.share = shareNear(truth, grid, 0.0);
  overlap.raised_share = overlap.share;
  for (int step = -kSteps; step <= kSteps; ++step) {
    const double share = shareNear(truth, grid, step * kStep);
    if (share <= overlap.raised_share) continue;
    overlap.raised_share = share;
    overlap.raise = step * kStep;
  }
  return overlap;
}

}  // namespace segdf

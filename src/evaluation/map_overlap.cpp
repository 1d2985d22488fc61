// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/map_overlap.hpp"

#include <algorithm>

#include "segdf/evaluation/point_grid.hpp"

namespace segdf {

namespace {

constexpr double kNear = 0.25;            // metres: more than half the diagonal of a 0.2 m voxel
constexpr std::size_t kEnough = 4000000;  // map points: more only take time
constexpr int kSteps = 30;        // of 0.1 m, up and down: a sensor stands no higher than 3 m
constexpr double kStep = 0.1;     // metres
constexpr double kEqual = 0.002;  // shares that differ by chance only

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
  std::vector<double> shares;
  for (int step = -kSteps; step <= kSteps; ++step) {
    shares.push_back(shareNear(truth, grid, step * kStep));
  }
  overlap.raised_share = *std::max_element(shares.begin(), shares.end());
  if (overlap.share >= overlap.raised_share - kEqual) return overlap;
  // Several heights fit equally well, as far as "near" reaches; the right one is in their middle.
  double sum = 0.0;
  int fitting = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    if (shares[k] < overlap.raised_share - kEqual) continue;
    sum += (static_cast<double>(k) - kSteps) * kStep;
    ++fitting;
  }
  overlap.raise = sum / fitting;
  return overlap;
}

}  // namespace segdf

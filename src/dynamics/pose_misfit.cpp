// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/pose_misfit.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "segdf/core/quantile.hpp"

namespace segdf {

namespace {

constexpr std::size_t kLookedAt = 16000;  // points of a scan, evenly spread
constexpr std::size_t kSamples = 500;     // of these
constexpr std::size_t kMinSamples = 50;
constexpr float kMaxRange = 30.0F;

/// Object points of the frame that can be compared, thinned to about kSamples.
std::vector<std::uint32_t> samplePoints(const KeyFrame& frame) {
  std::vector<std::uint32_t> usable;
  const std::size_t step = frame.scan.points.size() / kLookedAt + 1;
  for (std::size_t i = 0; i < frame.scan.points.size(); i += step) {
    const bool has_plane =
        frame.seg.roles[i] == PointRole::kObject && frame.seg.surfaces[i].hasNormal();
    if (has_plane && frame.scan.points[i].position().norm() < kMaxRange) {
      usable.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const std::size_t stride = usable.size() / kSamples + 1;
  std::vector<std::uint32_t> sample;
  for (std::size_t k = 0; k < usable.size(); k += stride) sample.push_back(usable[k]);
  return sample;
}

/// Nearest point of `to` so far, for each query cell's points.
struct Query {
  Eigen::Vector3f position;  ///< in the frame of `to`
  Eigen::Vector3f normal;
  float nearest = std::numeric_limits<float>::infinity();  ///< squared, metres
  double misfit = kUnmatchedMisfit;
};

void compare(const KeyFrame& to, std::size_t voxel, Query& query) {
  for (std::uint32_t k = to.seg.voxels.begin[voxel]; k < to.seg.voxels.begin[voxel + 1]; ++k) {
    const Eigen::Vector3f d = to.scan.points[to.seg.voxels.points[k]].position() - query.position;
    const float squared = d.squaredNorm();
    if (squared >= query.nearest) continue;
    query.nearest = squared;
    query.misfit = std::min(kUnmatchedMisfit, static_cast<double>(std::abs(query.normal.dot(d))));
  }
}

}  // namespace

double poseMisfit(const KeyFrame& from, const KeyFrame& to, const CurvedGrid& grid) {
  const Pose to_T_from = to.scan.pose.inverse() * from.scan.pose;
  std::vector<KeyedPoint> items;
  std::vector<Query> queries;
  for (std::uint32_t i : samplePoints(from)) {
    const Eigen::Vector3d x = to_T_from * from.scan.points[i].position().cast<double>();
    const Eigen::Vector3d n = to_T_from.linear() * from.seg.surfaces[i].normal.cast<double>();
    const auto key = grid.keyOf(x);
    if (!key) continue;
    items.emplace_back(*key, static_cast<std::uint32_t>(queries.size()));
    queries.push_back({x.cast<float>(), n.cast<float>()});
  }
  if (queries.size() < kMinSamples) return std::numeric_limits<double>::quiet_NaN();
  sortByKey(items);
  std::vector<CurvedGrid::Key> keys;
  keys.reserve(items.size());
  for (const KeyedPoint& item : items) keys.push_back(item.first);
  forEachNeighbour(keys, to.seg.voxels, grid, 1,
                   [&](std::size_t q, std::size_t v) { compare(to, v, queries[items[q].second]); });
  std::vector<double> misfits;
  misfits.reserve(queries.size());
  for (const Query& query : queries) misfits.push_back(query.misfit);
  return medianOf(std::move(misfits));
}

}  // namespace segdf

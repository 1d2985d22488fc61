// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/voxel_edit.hpp"

#include <cstddef>
#include <limits>
#include <utility>

namespace segdf {

namespace {

/// Keys of the added points, ascending, each with its index into `added`.
std::vector<KeyedPoint> keysOf(const std::vector<Point>& points,
                               const CurvedGrid& grid,
                               const std::vector<AddedPoint>& added) {
  std::vector<KeyedPoint> keys;
  for (std::uint32_t k = 0; k < added.size(); ++k) {
    const auto key = grid.keyOf(points[added[k].point].position().cast<double>());
    if (key) keys.emplace_back(*key, k);
  }
  sortByKey(keys);
  return keys;
}

/// Puts voxels together again from those there are and from added points, in the order of their
/// keys.
class VoxelMerge {
 public:
  VoxelMerge(const std::vector<PointRole>& roles,
             const std::vector<AddedPoint>& added,
             const std::vector<KeyedPoint>& keys)
      : roles_(roles), added_(added), keys_(keys) {}

  void merge(CurvedVoxels& voxels, Clusters& clusters) {
    reserve(voxels.size() + added_.size(), voxels.points.size() + added_.size());
    merged_.begin.push_back(0);
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      addNewVoxels(voxels.keys[v]);
      addVoxel(voxels, v);
      addPoints(voxels.keys[v]);
      close(voxels.keys[v], voxels.mean[v], voxels.deviation[v], clusters.of_voxel[v]);
    }
    addNewVoxels(std::numeric_limits<CurvedGrid::Key>::max());
    voxels = std::move(merged_);
    clusters.of_voxel = std::move(cluster_);
  }

 private:
  void reserve(std::size_t voxels, std::size_t points) {
    merged_.keys.reserve(voxels);
    merged_.begin.reserve(voxels + 1);
    merged_.points.reserve(points);
    merged_.mean.reserve(voxels);
    merged_.deviation.reserve(voxels);
    cluster_.reserve(voxels);
  }

  /// Of the added points before a key.
  void addNewVoxels(CurvedGrid::Key before) {
    while (next_ < keys_.size() && keys_[next_].first < before) {
      const KeyedPoint first = keys_[next_];
      addPoints(first.first);
      close(first.first, 0.0F, 0.0F, added_[first.second].cluster);
    }
  }

  void addVoxel(const CurvedVoxels& voxels, std::size_t v) {
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      if (roles_[voxels.points[k]] == PointRole::kObject)
        merged_.points.push_back(voxels.points[k]);
    }
  }

  void addPoints(CurvedGrid::Key key) {
    for (; next_ < keys_.size() && keys_[next_].first == key; ++next_) {
      merged_.points.push_back(added_[keys_[next_].second].point);
    }
  }

  void close(CurvedGrid::Key key, float mean, float deviation, std::int32_t cluster) {
    const auto end = static_cast<std::uint32_t>(merged_.points.size());
    if (end == merged_.begin.back()) return;
    merged_.keys.push_back(key);
    merged_.begin.push_back(end);
    merged_.mean.push_back(mean);
    merged_.deviation.push_back(deviation);
    cluster_.push_back(cluster);
  }

  const std::vector<PointRole>& roles_;
  const std::vector<AddedPoint>& added_;
  const std::vector<KeyedPoint>& keys_;
  std::size_t next_ = 0;  ///< of `keys_`
  CurvedVoxels merged_;
  std::vector<std::int32_t> cluster_;
};

}  // namespace

void editVoxels(const std::vector<Point>& points,
                const std::vector<PointRole>& roles,
                const CurvedGrid& grid,
                const std::vector<AddedPoint>& added,
                CurvedVoxels& voxels,
                Clusters& clusters) {
  const std::vector<KeyedPoint> keys = keysOf(points, grid, added);
  VoxelMerge(roles, added, keys).merge(voxels, clusters);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/clustering.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "segdf/segmentation/cluster_merge.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

constexpr std::uint32_t kCrediblePoints = 3;

/// The intensity gate of lines 5-11: may two neighbouring voxels be linked?
class Gate {
 public:
  Gate(const CurvedVoxels& voxels, const CurvedVoxelConfig& config)
      : voxels_(voxels), config_(config) {}

  bool allows(std::size_t a, std::size_t b) const {
    if (config_.gate == IntensityGate::kOff) return true;
    const bool alike = std::abs(static_cast<double>(voxels_.mean[a]) -
                                static_cast<double>(voxels_.mean[b])) < config_.thre_av;
    if (config_.gate == IntensityGate::kLiteral) return isEven(a) && isEven(b) && alike;
    const bool evidence = isEven(a) && isEven(b) && voxels_.count(a) >= kCrediblePoints &&
                          voxels_.count(b) >= kCrediblePoints;
    return alike || !evidence;
  }

 private:
  bool isEven(std::size_t voxel) const {
    return static_cast<double>(voxels_.deviation[voxel]) < config_.thre_cov;
  }

  const CurvedVoxels& voxels_;
  const CurvedVoxelConfig& config_;
};

/// Stage 1: connected components of occupied voxels.
UnionFind connectNeighbours(const CurvedVoxels& voxels,
                            const CurvedGrid& grid,
                            const CurvedVoxelConfig& config) {
  UnionFind components(voxels.size());
  const Gate gate(voxels, config);
  forEachNeighbourPair(voxels, grid, 1, [&](std::size_t a, std::size_t b) {
    if (gate.allows(a, b)) {
      components.unite(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    }
  });
  return components;
}

std::vector<ComponentSums> sumComponents(const std::vector<Point>& points,
                                         const std::vector<float>& intensity,
                                         const CurvedVoxels& voxels,
                                         UnionFind& components) {
  std::vector<ComponentSums> sums(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    ComponentSums& sum = sums[components.find(static_cast<std::uint32_t>(v))];
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      const std::uint32_t i = voxels.points[k];
      sum.bounds.extend(points[i].position());
      sum.intensity += static_cast<double>(intensity[i]);
      ++sum.points;
    }
  }
  return sums;
}

/// Numbers the components that are no noise by their smallest point index.
Clusters numberClusters(const CurvedVoxels& voxels,
                        const std::vector<ComponentSums>& sums,
                        const CurvedVoxelConfig& config,
                        UnionFind& components) {
  std::vector<std::uint32_t> first_point(voxels.size(), ~0U);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    std::uint32_t& first = first_point[components.find(static_cast<std::uint32_t>(v))];
    const auto begin = voxels.points.begin() + voxels.begin[v];
    const auto end = voxels.points.begin() + voxels.begin[v + 1];
    first = std::min(first, *std::min_element(begin, end));
  }
  std::vector<std::pair<std::uint32_t, std::size_t>> order;
  for (std::size_t root = 0; root < voxels.size(); ++root) {
    if (sums[root].points < static_cast<std::uint32_t>(config.n_noise)) continue;
    if (components.find(static_cast<std::uint32_t>(root)) == root) {
      order.emplace_back(first_point[root], root);
    }
  }
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> number(voxels.size(), Clusters::kNoise);
  for (std::size_t c = 0; c < order.size(); ++c)
    number[order[c].second] = static_cast<std::int32_t>(c);
  Clusters clusters;
  clusters.count = order.size();
  clusters.of_voxel.resize(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    clusters.of_voxel[v] = number[components.find(static_cast<std::uint32_t>(v))];
  }
  return clusters;
}

}  // namespace

std::vector<std::int32_t> clusterOfPoints(std::size_t points,
                                          const CurvedVoxels& voxels,
                                          const Clusters& clusters) {
  std::vector<std::int32_t> cluster(points, Clusters::kNoise);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      cluster[voxels.points[k]] = clusters.of_voxel[v];
    }
  }
  return cluster;
}

void dropSmallClusters(const CurvedVoxels& voxels, std::uint32_t n_noise, Clusters& clusters) {
  std::vector<std::uint32_t> size(clusters.count, 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const std::int32_t c = clusters.of_voxel[v];
    if (c != Clusters::kNoise) size[static_cast<std::size_t>(c)] += voxels.count(v);
  }
  std::vector<std::int32_t> number(clusters.count, Clusters::kNoise);
  clusters.count = 0;
  for (std::size_t c = 0; c < number.size(); ++c) {
    if (size[c] >= n_noise) number[c] = static_cast<std::int32_t>(clusters.count++);
  }
  for (std::int32_t& c : clusters.of_voxel) {
    if (c != Clusters::kNoise) c = number[static_cast<std::size_t>(c)];
  }
}

bool fitsMovableObject(const Eigen::AlignedBox3f& bounds, const CurvedVoxelConfig& config) {
  const Eigen::Vector3d size = bounds.sizes().cast<double>();
  return std::hypot(size.x(), size.y()) <= config.merge_diagonal &&
         size.z() <= config.merge_height &&
         std::max(size.x(), size.y()) <= config.merge_long_side &&
         std::min(size.x(), size.y()) <= config.merge_short_side;
}

Clusters clusterVoxels(const std::vector<Point>& points,
                       const std::vector<float>& intensity,
                       const CurvedVoxels& voxels,
                       const CurvedGrid& grid,
                       const CurvedVoxelConfig& config) {
  UnionFind components = connectNeighbours(voxels, grid, config);
  std::vector<ComponentSums> sums = sumComponents(points, intensity, voxels, components);
  mergeComponents(voxels, grid, config, components, sums);
  return numberClusters(voxels, sums, config, components);
}

}  // namespace segdf

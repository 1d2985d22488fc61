// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/cluster_merge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "segdf/segmentation/clustering.hpp"

namespace segdf {

namespace {

constexpr int kMaxPasses = 5;
constexpr std::uint32_t kCrediblePoints = 3;

/// Two voxels near enough to link their components.
struct Link {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// Two components and how alike they are; ordered as method.md 4.5 wants merges tried.
struct Candidate {
  double difference = 0.0;  ///< d_AV
  std::uint32_t a = 0;      ///< root, a < b
  std::uint32_t b = 0;

  bool operator<(const Candidate& other) const {
    return std::tie(difference, a, b) < std::tie(other.difference, other.a, other.b);
  }
};

class Merger {
 public:
  Merger(const CurvedVoxels& voxels,
         const CurvedVoxelConfig& config,
         UnionFind& components,
         std::vector<ComponentSums>& sums)
      : voxels_(voxels), config_(config), components_(components), sums_(sums) {}

  /// Unions only grow: what is too large together now stays so.
  void collectLinks(const CurvedGrid& grid) {
    std::vector<std::uint32_t> root(voxels_.size());
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = components_.find(v);
    forEachNeighbourPair(voxels_, grid, config_.ext, [&](std::size_t a, std::size_t b) {
      if (root[a] == root[b] || !fitsTogether(root[a], root[b])) return;
      links_.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    });
  }

  /// @returns true when anything was united
  bool pass() {
    bool merged = false;
    for (const Candidate& candidate : candidates()) merged = tryMerge(candidate) || merged;
    return merged;
  }

 private:
  bool isNoise(std::uint32_t root) const {
    return sums_[root].points < static_cast<std::uint32_t>(config_.n_noise);
  }

  bool isCredible(std::uint32_t voxel) const {
    return voxels_.count(voxel) >= kCrediblePoints &&
           static_cast<double>(voxels_.deviation[voxel]) < config_.thre_cov;
  }

  /// Component pairs still apart, alike, and small enough, in the order in which to try them.
  std::vector<Candidate> candidates() {
    struct Pair {
      std::uint32_t a, b;
      Link link;
    };
    std::vector<Pair> pairs;
    for (const Link& link : links_) {
      std::uint32_t a = components_.find(link.a);
      std::uint32_t b = components_.find(link.b);
      if (a == b || (isNoise(a) && isNoise(b)) || !fitsTogether(a, b)) continue;
      if (b < a) std::swap(a, b);
      pairs.push_back({a, b, link});
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return std::tie(x.a, x.b) < std::tie(y.a, y.b);
    });
    std::vector<Candidate> result;
    for (std::size_t first = 0; first < pairs.size();) {
      LinkMean links;
      std::size_t last = first;
      for (; last < pairs.size() && pairs[last].a == pairs[first].a &&
             pairs[last].b == pairs[first].b;
           ++last) {
        addLink(pairs[last].link, links);
      }
      const Candidate candidate{difference(pairs[first].a, pairs[first].b, links), pairs[first].a,
                                pairs[first].b};
      if (candidate.difference <= config_.thre_av) result.push_back(candidate);
      first = last;
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  struct LinkMean {
    double sum = 0.0;
    std::size_t count = 0;
  };

  /// Condition s2: a pair with a voxel that is not credible does not count.
  void addLink(const Link& link, LinkMean& mean) const {
    if (!isCredible(link.a) || !isCredible(link.b)) return;
    mean.sum += std::abs(static_cast<double>(voxels_.mean[link.a]) -
                         static_cast<double>(voxels_.mean[link.b]));
    ++mean.count;
  }

  /// Condition s1: the smaller of the difference of means and the mean difference at the seam.
  double difference(std::uint32_t a, std::uint32_t b, const LinkMean& links) const {
    const double of_means = std::abs(sums_[a].meanIntensity() - sums_[b].meanIntensity());
    if (links.count == 0) return of_means;
    return std::min(of_means, links.sum / static_cast<double>(links.count));
  }

  /// Condition s3 for the union.
  bool fitsTogether(std::uint32_t a, std::uint32_t b) const {
    return fitsMovableObject(sums_[a].bounds.merged(sums_[b].bounds), config_);
  }

  /// Earlier merges of the same pass may have grown either side: s3 must hold for what they are
  /// now.
  bool tryMerge(const Candidate& candidate) {
    const std::uint32_t a = components_.find(candidate.a);
    const std::uint32_t b = components_.find(candidate.b);
    if (a == b || !fitsTogether(a, b)) return false;
    const std::uint32_t root = components_.unite(a, b);
    sums_[root].add(sums_[root == a ? b : a]);
    return true;
  }

  const CurvedVoxels& voxels_;
  const CurvedVoxelConfig& config_;
  UnionFind& components_;
  std::vector<ComponentSums>& sums_;
  std::vector<Link> links_;
};

}  // namespace

void mergeComponents(const CurvedVoxels& voxels,
                     const CurvedGrid& grid,
                     const CurvedVoxelConfig& config,
                     UnionFind& components,
                     std::vector<ComponentSums>& sums) {
  Merger merger(voxels, config, components, sums);
  merger.collectLinks(grid);
  for (int pass = 0; pass < kMaxPasses && merger.pass(); ++pass) {
  }
}

}  // namespace segdf

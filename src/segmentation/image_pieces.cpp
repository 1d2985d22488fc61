// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/image_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

constexpr int kLeastReach = 2;
constexpr int kMostReach = 8;

/// Twice the columns between neighbours in the fullest row: a sensor may have fewer than the image.
int reachOf(const RangeImage& image, std::size_t points) {
  std::vector<int> returns(static_cast<std::size_t>(image.rows()), 0);
  int fullest = 1;
  for (std::size_t i = 0; i < points; ++i) {
    if (image.rowOf(i) == RangeImage::kNone) continue;
    fullest = std::max(fullest, ++returns[static_cast<std::size_t>(image.rowOf(i))]);
  }
  return std::clamp((2 * image.columns() + fullest / 2) / fullest, kLeastReach, kMostReach);
}

class Connector {
 public:
  Connector(const RangeImage& image,
            const std::vector<std::int32_t>& cluster,
            float jump,
            int reach)
      : image_(image), cluster_(cluster), jump_(jump), reach_(reach) {}

  UnionFind connect() const {
    UnionFind pieces(cluster_.size());
    for (std::uint32_t i = 0; i < cluster_.size(); ++i) {
      if (cluster_[i] != Clusters::kNoise) connectPoint(i, pieces);
    }
    return pieces;
  }

 private:
  /// To the point that the image holds of its cell, to those to the right and to those below.
  void connectPoint(std::uint32_t i, UnionFind& pieces) const {
    const int row = image_.rowOf(i);
    const int column = image_.columnOf(i);
    std::uint32_t root = pieces.find(i);
    for (int right = 0; right <= reach_; ++right) {
      root = connectPair(i, root, image_.at(row, column + right), pieces);
    }
    for (int right = -reach_; right <= reach_; ++right) {
      root = connectPair(i, root, image_.at(row + 1, column + right), pieces);
    }
  }

  /// @returns the root of `a` afterwards
  std::uint32_t connectPair(std::uint32_t a,
                            std::uint32_t root,
                            std::int32_t neighbour,
                            UnionFind& pieces) const {
    const auto b = static_cast<std::uint32_t>(neighbour);
    if (neighbour == RangeImage::kNone || a == b || cluster_[a] != cluster_[b]) return root;
    if (std::abs(image_.rangeOf(a) - image_.rangeOf(b)) >= jump_) return root;
    return pieces.unite(root, b);
  }

  const RangeImage& image_;
  const std::vector<std::int32_t>& cluster_;
  float jump_;
  int reach_;
};

}  // namespace

ImagePieces::ImagePieces(const RangeImage& image,
                         const std::vector<std::int32_t>& cluster,
                         float jump)
    : reach_(reachOf(image, cluster.size())),
      cluster_(cluster),
      root_(cluster.size()),
      size_(cluster.size(), 0) {
  UnionFind pieces = Connector(image, cluster, jump, reach_).connect();
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    root_[i] = pieces.find(i);
    if (cluster[i] == Clusters::kNoise) continue;
    ++size_[root_[i]];
    const auto c = static_cast<std::size_t>(cluster[i]);
    if (c >= cluster_size_.size()) cluster_size_.resize(c + 1, 0);
    ++cluster_size_[c];
  }
}

std::vector<ImagePiece> ImagePieces::largerThan(std::uint32_t min_points) const {
  std::vector<ImagePiece> pieces;
  std::vector<std::size_t> number(root_.size(), 0);
  for (std::uint32_t i = 0; i < root_.size(); ++i) {
    const std::uint32_t root = root_[i];
    if (size_[root] < min_points) continue;
    if (size_[root] == cluster_size_[static_cast<std::size_t>(cluster_[i])]) continue;
    if (root == i) {  // roots are the smallest point, so they come first
      number[root] = pieces.size();
      pieces.push_back({root, cluster_[i], {}});
      pieces.back().points.reserve(size_[root]);
    }
    pieces[number[root]].points.push_back(i);
  }
  return pieces;
}

}  // namespace segdf

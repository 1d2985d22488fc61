// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/image_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/segmentation/clustering.hpp"

namespace segdf {

namespace {

/// Unites neighbours that differ by less than `jump`, and keeps those from there to `next_jump`.
class Connector {
 public:
  Connector(const RangeImage& image,
            const std::vector<std::int32_t>& cluster,
            float jump,
            float next_jump,
            UnionFind& pieces,
            std::vector<ImageLink>& next_links)
      : image_(image),
        cluster_(cluster),
        jump_(jump),
        next_jump_(next_jump),
        reach_(image.reach()),
        pieces_(pieces),
        next_links_(next_links) {}

  /// To the point that the image holds of its cell, to those to the right and to those below.
  void connect(std::uint32_t i) {
    const int row = image_.rowOf(i);
    const int column = image_.columnOf(i);
    std::uint32_t root = pieces_.find(i);
    for (int right = 0; right <= reach_; ++right) {
      root = connectPair(i, root, image_.at(row, column + right));
    }
    for (int right = -reach_; right <= reach_; ++right) {
      root = connectPair(i, root, image_.at(row + 1, column + right));
    }
  }

 private:
  /// @returns the root of `a` afterwards
  std::uint32_t connectPair(std::uint32_t a, std::uint32_t root, std::int32_t neighbour) {
    const auto b = static_cast<std::uint32_t>(neighbour);
    if (neighbour == RangeImage::kNone || a == b || cluster_[a] != cluster_[b]) return root;
    const float difference = std::abs(image_.rangeOf(a) - image_.rangeOf(b));
    if (difference < jump_) return pieces_.unite(root, b);
    if (difference < next_jump_) next_links_.push_back({a, b});
    return root;
  }

  const RangeImage& image_;
  const std::vector<std::int32_t>& cluster_;
  float jump_;
  float next_jump_;
  int reach_;
  UnionFind& pieces_;
  std::vector<ImageLink>& next_links_;
};

std::size_t numberOfClusters(const std::vector<std::int32_t>& cluster) {
  std::size_t count = 0;
  for (std::int32_t c : cluster) {
    if (c != Clusters::kNoise) count = std::max(count, static_cast<std::size_t>(c) + 1);
  }
  return count;
}

}  // namespace

ImagePieces::ImagePieces(const RangeImage& image,
                         const std::vector<std::int32_t>& cluster,
                         float jump,
                         float next_jump)
    : image_(image),
      jump_(jump),
      next_jump_(next_jump),
      cluster_(cluster),
      pieces_(cluster.size()) {
  Connector connector(image_, cluster_, jump, next_jump, pieces_, next_links_);
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    if (cluster[i] != Clusters::kNoise) connector.connect(i);
  }
  count();
}

std::vector<std::uint8_t> ImagePieces::findStale(const std::vector<std::int32_t>& cluster) const {
  std::vector<std::uint8_t> stale(cluster_size_.size(), next_jump_ < jump_ ? 1 : 0);
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    if (cluster[i] != cluster_[i]) stale[static_cast<std::size_t>(cluster_[i])] = 1;
  }
  return stale;
}

void ImagePieces::proceed(const std::vector<std::int32_t>& cluster) {
  const std::vector<std::uint8_t> stale = findStale(cluster);
  const auto is_stale = [&](std::uint32_t i) {
    return cluster_[i] != Clusters::kNoise && stale[static_cast<std::size_t>(cluster_[i])] != 0;
  };
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    if (is_stale(i)) pieces_.isolate(i);
  }
  std::vector<ImageLink> none;
  Connector connector(image_, cluster, next_jump_, next_jump_, pieces_, none);
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    if (is_stale(i)) connector.connect(i);
  }
  for (const ImageLink& link : next_links_) {
    if (!is_stale(link.a)) pieces_.unite(link.a, link.b);
  }
  cluster_ = cluster;
  count();
}

void ImagePieces::count() {
  root_.resize(cluster_.size());
  size_.assign(cluster_.size(), 0);
  cluster_size_.assign(numberOfClusters(cluster_), 0);
  for (std::uint32_t i = 0; i < cluster_.size(); ++i) {
    root_[i] = pieces_.find(i);
    if (cluster_[i] == Clusters::kNoise) continue;
    ++size_[root_[i]];
    ++cluster_size_[static_cast<std::size_t>(cluster_[i])];
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

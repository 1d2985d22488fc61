// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/image_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "segdf/segmentation/clustering.hpp"

namespace segdf {

namespace {

/// Unites neighbours that differ by less than `jump`, and keeps those from there to `next_jump`.
/// Row by row: beside and below a point there is mostly what is of its piece already.
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

  /// All points in clusters. @param members these
  void connectAll(const std::vector<std::uint32_t>& members) {
    Row above(image_.columns(), reach_);
    Row row(image_.columns(), reach_);
    for (int r = 0; r < image_.rows(); ++r) {
      load(r, row);
      connectRow(above, row);
      std::swap(above, row);
    }
    for (std::uint32_t i : members) {
      const bool shown =
          image_.at(image_.rowOf(i), image_.columnOf(i)) == static_cast<std::int32_t>(i);
      if (!shown) connect(i);
    }
  }

  /// To the point that the image holds of its cell, to those to the right and to those below.
  void connect(std::uint32_t i) {
    const int row = image_.rowOf(i);
    const int column = image_.columnOf(i);
    for (int right = 0; right <= reach_; ++right) {
      connectPair(i, image_.at(row, column + right));
    }
    for (int right = -reach_; right <= reach_; ++right) {
      connectPair(i, image_.at(row + 1, column + right));
    }
  }

 private:
  /// What one row of the image shows, with `reach` wrapped columns on both sides.
  struct Row {
    std::vector<std::int32_t> cluster;
    std::vector<float> range;
    std::vector<std::uint32_t> point;
    std::vector<std::uint32_t> piece;  ///< any point of the piece that the point is of

    Row(int columns, int reach)
        : cluster(static_cast<std::size_t>(columns + 2 * reach), Clusters::kNoise),
          range(cluster.size()),
          point(cluster.size()),
          piece(cluster.size()) {}
  };

  void load(int r, Row& row) const {
    for (std::size_t c = 0; c < row.cluster.size(); ++c) {
      const std::int32_t shown = image_.at(r, static_cast<int>(c) - reach_);
      row.cluster[c] = Clusters::kNoise;
      if (shown == RangeImage::kNone) continue;
      const auto i = static_cast<std::uint32_t>(shown);
      row.cluster[c] = cluster_[i];
      row.range[c] = image_.rangeOf(i);
      row.point[c] = i;
      row.piece[c] = i;
    }
  }

  /// To the points to the left and to those above.
  void connectRow(Row& above, Row& row) {
    const auto reach = static_cast<std::size_t>(reach_);
    for (std::size_t c = reach; c + reach < row.cluster.size(); ++c) {
      if (row.cluster[c] == Clusters::kNoise) continue;
      for (std::size_t left = 1; left <= reach; ++left) connectPair(row, c, row, c - left);
      for (std::size_t beside = c - reach; beside <= c + reach; ++beside) {
        connectPair(row, c, above, beside);
      }
    }
  }

  void connectPair(Row& row, std::size_t c, Row& other, std::size_t o) {
    if (row.cluster[c] != other.cluster[o] || row.piece[c] == other.piece[o]) return;
    if (!isLink(row.point[c], row.range[c], other.point[o], other.range[o])) return;
    row.piece[c] = other.piece[o] = pieces_.unite(row.piece[c], other.piece[o]);
  }

  /// Notes what is none, but will be one next.
  bool isLink(std::uint32_t a, float range_a, std::uint32_t b, float range_b) {
    const float difference = std::abs(range_a - range_b);
    if (difference >= jump_ && difference < next_jump_) next_links_.push_back({a, b});
    return difference < jump_;
  }

  void connectPair(std::uint32_t a, std::int32_t shown) {
    const auto b = static_cast<std::uint32_t>(shown);
    if (shown == RangeImage::kNone || a == b || cluster_[a] != cluster_[b]) return;
    if (isLink(a, image_.rangeOf(a), b, image_.rangeOf(b))) pieces_.unite(a, b);
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
      pieces_(cluster.size()),
      root_(cluster.size()),
      size_(cluster.size(), 0) {
  std::iota(root_.begin(), root_.end(), 0U);
  members_.reserve(cluster.size());
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    if (cluster[i] != Clusters::kNoise) members_.push_back(i);
  }
  Connector(image_, cluster_, jump, next_jump, pieces_, next_links_).connectAll(members_);
  count();
}

std::vector<std::uint8_t> ImagePieces::findStale(const std::vector<std::int32_t>& cluster) const {
  std::vector<std::uint8_t> stale(cluster_size_.size(), next_jump_ < jump_ ? 1 : 0);
  for (std::uint32_t i : members_) {
    if (cluster[i] != cluster_[i]) stale[static_cast<std::size_t>(cluster_[i])] = 1;
  }
  return stale;
}

void ImagePieces::proceed(const std::vector<std::int32_t>& cluster) {
  const std::vector<std::uint8_t> stale = findStale(cluster);
  const auto is_stale = [&](std::uint32_t i) {
    return stale[static_cast<std::size_t>(cluster_[i])] != 0;
  };
  std::vector<std::uint32_t> anew;
  for (std::uint32_t i : members_) {
    if (!is_stale(i)) continue;
    pieces_.isolate(i);
    anew.push_back(i);
  }
  std::vector<ImageLink> none;
  Connector connector(image_, cluster, next_jump_, next_jump_, pieces_, none);
  for (std::uint32_t i : anew) connector.connect(i);
  for (const ImageLink& link : next_links_) {
    if (!is_stale(link.a)) pieces_.unite(link.a, link.b);
  }
  cluster_ = cluster;
  count();
}

void ImagePieces::count() {
  cluster_size_.assign(numberOfClusters(cluster_), 0);
  for (std::uint32_t i : members_) size_[i] = 0;
  for (std::uint32_t i : members_) {
    root_[i] = pieces_.find(i);
    ++size_[root_[i]];
    ++cluster_size_[static_cast<std::size_t>(cluster_[i])];
  }
}

std::vector<ImagePiece> ImagePieces::largerThan(std::uint32_t min_points) const {
  std::vector<ImagePiece> pieces;
  std::vector<std::uint32_t> number(root_.size(), 0);
  for (std::uint32_t i : members_) {
    const std::uint32_t root = root_[i];
    if (size_[root] < min_points) continue;
    if (size_[root] == cluster_size_[static_cast<std::size_t>(cluster_[i])]) continue;
    if (root == i) {  // roots are the smallest point, so they come first
      number[root] = static_cast<std::uint32_t>(pieces.size());
      pieces.push_back({root, cluster_[i], {}});
      pieces.back().points.reserve(size_[root]);
    }
    pieces[number[root]].points.push_back(i);
  }
  return pieces;
}

}  // namespace segdf

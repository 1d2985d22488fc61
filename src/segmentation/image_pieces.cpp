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

/// The cells of the range image side by side, with a rim of wrapped columns and an empty row below,
/// so that neighbours need no bounds.
class Cells {
 public:
  Cells(const RangeImage& image, const std::vector<std::int32_t>& cluster, int reach)
      : stride_(image.columns() + 2 * reach),
        cells_(static_cast<std::size_t>((image.rows() + 1) * stride_)) {
    std::size_t cell = 0;
    for (int row = 0; row < image.rows(); ++row) {
      for (int column = -reach; column < image.columns() + reach; ++column, ++cell) {
        const std::int32_t i = image.at(row, column);
        if (i == RangeImage::kNone) continue;
        const auto point = static_cast<std::size_t>(i);
        cells_[cell] = {static_cast<std::uint32_t>(i), cluster[point], image.rangeOf(point)};
      }
    }
  }

  struct Cell {
    std::uint32_t point = 0;
    std::int32_t cluster = Clusters::kNoise;
    float range = 0.0F;
  };

  /// @param column from the image's first, without the rim
  const Cell* at(int row, int column, int reach) const {
    return cells_.data() + static_cast<std::ptrdiff_t>(row) * stride_ + column + reach;
  }
  std::ptrdiff_t stride() const { return stride_; }

 private:
  std::ptrdiff_t stride_;
  std::vector<Cell> cells_;
};

/// Connects what the image holds of each cell to what lies to the right and below.
void connectCells(const RangeImage& image,
                  const std::vector<std::int32_t>& cluster,
                  float jump,
                  int reach,
                  UnionFind& pieces) {
  const Cells cells(image, cluster, reach);
  for (int row = 0; row < image.rows(); ++row) {
    for (int column = 0; column < image.columns(); ++column) {
      const Cells::Cell* cell = cells.at(row, column, reach);
      if (cell->cluster == Clusters::kNoise) continue;
      const auto connect = [&](const Cells::Cell& next) {
        if (next.cluster != cell->cluster || std::abs(next.range - cell->range) >= jump) return;
        pieces.unite(cell->point, next.point);
      };
      for (int right = 1; right <= reach; ++right) connect(cell[right]);
      for (int right = -reach; right <= reach; ++right) connect(cell[cells.stride() + right]);
    }
  }
}

/// Connects the points of a cell that the image does not hold to the one that it does, and to what
/// lies to the right of it and below.
void connectHidden(const RangeImage& image,
                   const std::vector<std::int32_t>& cluster,
                   float jump,
                   int reach,
                   UnionFind& pieces) {
  for (std::uint32_t i = 0; i < cluster.size(); ++i) {
    if (cluster[i] == Clusters::kNoise) continue;
    const int row = image.rowOf(i);
    const int column = image.columnOf(i);
    if (image.at(row, column) == static_cast<std::int32_t>(i)) continue;
    const auto connect = [&](std::int32_t next) {
      if (next == RangeImage::kNone) return;
      const auto b = static_cast<std::uint32_t>(next);
      if (cluster[b] != cluster[i]) return;
      if (std::abs(image.rangeOf(b) - image.rangeOf(i)) < jump) pieces.unite(i, b);
    };
    for (int right = 0; right <= reach; ++right) connect(image.at(row, column + right));
    for (int right = -reach; right <= reach; ++right) connect(image.at(row + 1, column + right));
  }
}

}  // namespace

ImagePieces::ImagePieces(const RangeImage& image,
                         const std::vector<std::int32_t>& cluster,
                         float jump)
    : reach_(reachOf(image, cluster.size())),
      cluster_(cluster),
      root_(cluster.size()),
      size_(cluster.size(), 0) {
  UnionFind pieces(cluster.size());
  connectCells(image, cluster, jump, reach_, pieces);
  connectHidden(image, cluster, jump, reach_, pieces);
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

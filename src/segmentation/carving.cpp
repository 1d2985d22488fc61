// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/carving.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "segdf/segmentation/footprint.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

constexpr float kTurn = 6.28318531F;
// A cyclist with what is close behind, and the greatest single vehicle.
constexpr float kCyclistLength = 3.5F;
constexpr float kCyclistWidth = 1.1F;
constexpr float kVehicleLength = 13.0F;
constexpr float kVehicleWidth = 2.9F;
// Chairs, tables and hedges end below a person's chest.
constexpr float kChest = 1.0F;
// More of the cluster beside a piece: within this to the side, metres, and in range.
constexpr float kFlankReach = 0.5F;
constexpr float kFlankDepth = 0.2F;
// Columns looked across for what borders on a piece: every other one may be without return.
constexpr int kBorderReach = 2;

/// What a cluster falls into.
struct Piece {
  std::uint32_t root = 0;
  std::int32_t cluster = 0;
  std::vector<std::uint32_t> points;  ///< ascending
};

class Carver {
 public:
  Carver(const std::vector<Point>& points,
         const RangeImage& image,
         const std::vector<float>& height,
         const CarveConfig& config,
         const CurvedVoxels& voxels,
         Clusters& clusters)
      : points_(points),
        image_(image),
        height_(height),
        config_(config),
        voxels_(voxels),
        clusters_(clusters),
        cluster_(points.size(), Clusters::kNoise),
        pieces_(points.size()) {
    for (std::size_t v = 0; v < voxels.size(); ++v) {
      for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
        cluster_[voxels.points[k]] = clusters.of_voxel[v];
      }
    }
  }

  void carve() {
    connect();
    std::vector<Piece> persons;
    for (Piece& piece : largePieces()) {
      if (isPerson(piece) ) persons.push_back(std::move(piece));
    }
    assign(choose(persons));
  }

 private:
  bool sameCluster(std::uint32_t a, std::int32_t b) const {
    return b != RangeImage::kNone && cluster_[static_cast<std::size_t>(b)] == cluster_[a];
  }

  void uniteIfNear(std::uint32_t a, std::int32_t b) {
    if (!sameCluster(a, b)) return;
    const auto other = static_cast<std::uint32_t>(b);
    const auto jump = static_cast<float>(config_.jump);
    if (std::abs(image_.rangeOf(a) - image_.rangeOf(other)) < jump) pieces_.unite(a, other);
  }

  void connect() {
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise) continue;
      const int row = image_.rowOf(i);
      const int column = image_.columnOf(i);
      // Of several points in one cell the image holds one.
      uniteIfNear(i, image_.at(row, column));
      for (int right = 1; right <= kBorderReach; ++right) uniteIfNear(i, image_.at(row, column + right));
      for (int right = -kBorderReach; right <= kBorderReach; ++right) {
        uniteIfNear(i, image_.at(row + 1, column + right));
      }
    }
  }

  /// Pieces of enough points that are not the whole cluster, by smallest point.
  std::vector<Piece> largePieces() {
    std::vector<std::uint32_t> size(points_.size(), 0);
    std::vector<std::uint32_t> cluster_size(clusters_.count, 0);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise) continue;
      ++size[pieces_.find(i)];
      ++cluster_size[static_cast<std::size_t>(cluster_[i])];
    }
    std::vector<Piece> large;
    constexpr std::uint32_t kSmall = ~0U;
    std::vector<std::uint32_t> number(points_.size(), kSmall);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise) continue;
      const std::uint32_t root = pieces_.find(i);
      const auto cluster = static_cast<std::size_t>(cluster_[i]);
      if (size[root] < static_cast<std::uint32_t>(config_.min_points)) continue;
      if (size[root] == cluster_size[cluster]) continue;
      if (number[root] == kSmall) {
        number[root] = static_cast<std::uint32_t>(large.size());
        large.push_back({root, cluster_[i], {}});
        large.back().points.reserve(size[root]);
      }
      large[number[root]].points.push_back(i);
    }
    return large;
  }

  bool isPerson(const Piece& piece) const {
    Footprint footprint;
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::uint32_t i : piece.points) {
      footprint.add(points_[i].x, points_[i].y);
      low = std::min(low, height_[i]);
      high = std::max(high, height_[i]);
    }
    const auto length = static_cast<double>(footprint.length());
    const auto width = static_cast<double>(footprint.width());
    const auto top = static_cast<double>(high);
    return top >= config_.top_min && top <= config_.top_max &&
           static_cast<double>(high - low) >= config_.height && length >= config_.length_min &&
           length <= config_.length_max && width <= config_.width_max;
  }

  /// The next point to the side, kNone when there is none near or it is of the same piece.
  struct Border {
    std::size_t all = 0;
    std::size_t hidden = 0;
    std::size_t upper = 0;
    std::size_t flanked = 0;
  };

  bool inPiece(const Piece& piece, std::int32_t point) {
    return sameCluster(piece.root, point) &&
           pieces_.find(static_cast<std::uint32_t>(point)) == piece.root;
  }

  void addBorder(const Piece& piece, std::uint32_t i, int side, Border& border) {
    const int row = image_.rowOf(i);
    const int column = image_.columnOf(i);
    std::int32_t next = RangeImage::kNone;
    for (int step = 1; step <= kBorderReach && next == RangeImage::kNone; ++step) {
      next = image_.at(row, column + side * step);
    }
    if (inPiece(piece, next)) return;
    ++border.all;
    if (next != RangeImage::kNone && image_.rangeOf(static_cast<std::size_t>(next)) <
                                         image_.rangeOf(i) - static_cast<float>(config_.jump)) {
      ++border.hidden;
    }
    if (height_[i] < kChest) return;
    ++border.upper;
    if (isFlanked(piece, i, side)) ++border.flanked;
  }

  void addTop(const Piece& piece, std::uint32_t i, Border& border) {
    const int row = image_.rowOf(i);
    const int column = image_.columnOf(i);
    if (height_[i] < kChest) return;
    for (int up = 1; up <= kBorderReach; ++up) {
      if (inPiece(piece, image_.at(row - up, column))) return;
    }
    ++border.upper;
    for (int up = 1; row - up >= 0; ++up) {
      const std::int32_t j = image_.at(row - up, column);
      if (j == RangeImage::kNone) continue;
      if (height_[j] > height_[i] + kFlankReach) return;
      if (!sameCluster(piece.root, j)) continue;
      if (std::abs(image_.rangeOf(static_cast<std::size_t>(j)) - image_.rangeOf(i)) < kFlankDepth) {
        ++border.flanked;
        return;
      }
    }
  }

  bool isFlanked(const Piece& piece, std::uint32_t i, int side) {
    const float width = image_.rangeOf(i) * kTurn / static_cast<float>(image_.columns());
    const int reach = std::max(1, static_cast<int>(kFlankReach / width));
    for (int step = 1; step <= reach; ++step) {
      const std::int32_t j = image_.at(image_.rowOf(i), image_.columnOf(i) + side * step);
      if (!sameCluster(piece.root, j) || inPiece(piece, j)) continue;
      if (std::abs(image_.rangeOf(static_cast<std::size_t>(j)) - image_.rangeOf(i)) < kFlankDepth) {
        return true;
      }
    }
    return false;
  }

  Border borderOf(const Piece& piece) {
    Border border;
    for (std::uint32_t i : piece.points) {
      if (image_.at(image_.rowOf(i), image_.columnOf(i)) != static_cast<std::int32_t>(i)) continue;
      addBorder(piece, i, -1, border);
      addBorder(piece, i, 1, border);
      addTop(piece, i, border);
    }
    return border;
  }

  bool isFree(const Piece& piece, bool beyond_vehicle) {
    const Border border = borderOf(piece);
    const double flanked = beyond_vehicle ? config_.flanked_large : config_.flanked;
    const auto share = [](std::size_t part, double limit, std::size_t whole) {
      return static_cast<double>(part) <= limit * static_cast<double>(whole);
    };
    const bool open = static_cast<double>(border.all) >=
                      config_.open * static_cast<double>(piece.points.size());
    return open && share(border.hidden, config_.hidden, border.all) &&
           share(border.flanked, flanked, border.upper);
  }

  std::vector<Piece> choose(std::vector<Piece>& persons) {
    std::vector<Footprint> footprints(clusters_.count);
    std::vector<std::size_t> seen(clusters_.count, 0);
    for (const Piece& p : persons) ++seen[static_cast<std::size_t>(p.cluster)];
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise || seen[static_cast<std::size_t>(cluster_[i])] == 0) continue;
      footprints[static_cast<std::size_t>(cluster_[i])].add(points_[i].x, points_[i].y);
    }
    std::vector<Piece> chosen;
    std::vector<std::size_t> first(clusters_.count, 0);
    for (Piece& p : persons) {
      const auto c = static_cast<std::size_t>(p.cluster);
      const float l = footprints[c].length(), w = footprints[c].width();
      const bool small = l <= kCyclistLength && w <= kCyclistWidth;
      if (!isFree(p, l > kVehicleLength || w > kVehicleWidth)) continue;
      if (small && first[c]++ == 0) continue;
      chosen.push_back(std::move(p));
    }
    return chosen;
  }

  void assign(const std::vector<Piece>& chosen) {
    std::vector<std::int32_t> target = cluster_;
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      for (std::uint32_t i : chosen[k].points) {
        target[i] = static_cast<std::int32_t>(clusters_.count + k);
      }
    }
    for (std::size_t v = 0; v < voxels_.size(); ++v) {
      if (clusters_.of_voxel[v] == Clusters::kNoise) continue;
      clusters_.of_voxel[v] = majority(target, v);
    }
    clusters_.count += chosen.size();
  }

  std::int32_t majority(const std::vector<std::int32_t>& target, std::size_t v) const {
    std::int32_t best = clusters_.of_voxel[v];
    std::size_t most = 0;
    for (std::uint32_t k = voxels_.begin[v]; k < voxels_.begin[v + 1]; ++k) {
      const std::int32_t t = target[voxels_.points[k]];
      std::size_t n = 0;
      for (std::uint32_t m = voxels_.begin[v]; m < voxels_.begin[v + 1]; ++m) {
        n += target[voxels_.points[m]] == t ? 1 : 0;
      }
      if (n > most) {
        most = n;
        best = t;
      }
    }
    return best;
  }

  const std::vector<Point>& points_;
  const RangeImage& image_;
  const std::vector<float>& height_;
  const CarveConfig& config_;
  const CurvedVoxels& voxels_;
  Clusters& clusters_;
  std::vector<std::int32_t> cluster_;  ///< of each point
  UnionFind pieces_;                   ///< over the points
};

}  // namespace

void carveClusters(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const CarveConfig& config,
                   const CurvedVoxels& voxels,
                   Clusters& clusters) {
  if (config.jump <= 0.0) return;
  Carver(points, image, height, config, voxels, clusters).carve();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/carving.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "segdf/segmentation/footprint.hpp"
#include "segdf/segmentation/image_pieces.hpp"

namespace segdf {

namespace {

constexpr float kTurn = 6.28318531F;
// A cyclist with what is close behind, and the greatest single vehicle, metres.
constexpr float kCyclistLength = 3.5F;
constexpr float kCyclistWidth = 1.1F;
constexpr float kVehicleLength = 13.0F;
constexpr float kVehicleWidth = 2.9F;
// Chairs, tables and low hedges end below this height, metres.
constexpr float kChest = 1.0F;
// A cluster goes on beside or above a piece when more of it is within this to the side, and in
// range, metres.
constexpr float kFlankReach = 0.5F;
constexpr float kFlankDepth = 0.2F;
// Fragments less than half its size belong to a piece when they stand out of its footprint, and
// over its top, by less, metres.
constexpr float kMargin = 0.1F;

/// Horizontal and vertical extent of a piece, metres.
struct Extent {
  Footprint footprint;
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
};

/// What a piece borders on.
struct Border {
  std::size_t sides = 0;    ///< points at its left and right border
  std::size_t hidden = 0;   ///< those that lie behind what is beside them
  std::size_t upper = 0;    ///< points at its border from the chest up, its top included
  std::size_t flanked = 0;  ///< those beyond which its cluster goes on
};

/// Measures the border of one piece.
class BorderWalk {
 public:
  BorderWalk(const RangeImage& image,
             const std::vector<float>& height,
             const std::vector<std::int32_t>& cluster,
             const ImagePieces& pieces,
             const ImagePiece& piece,
             float jump)
      : image_(image),
        height_(height),
        cluster_(cluster),
        pieces_(pieces),
        piece_(piece),
        jump_(jump) {}

  Border walk() {
    for (std::uint32_t i : piece_.points) {
      // Of several points in one cell the image shows one.
      if (image_.at(image_.rowOf(i), image_.columnOf(i)) != static_cast<std::int32_t>(i)) continue;
      addSide(i, -1);
      addSide(i, 1);
      addTop(i);
    }
    return border_;
  }

 private:
  /// First point within reach in a direction, kNone when there is none.
  std::int32_t neighbour(std::uint32_t i, int down, int right) const {
    std::int32_t found = RangeImage::kNone;
    for (int step = 1; step <= ImagePieces::kReach && found == RangeImage::kNone; ++step) {
      found = image_.at(image_.rowOf(i) + down * step, image_.columnOf(i) + right * step);
    }
    return found;
  }

  void addSide(std::uint32_t i, int right) {
    const std::int32_t next = neighbour(i, 0, right);
    if (pieces_.contains(piece_, next)) return;
    ++border_.sides;
    if (next != RangeImage::kNone &&
        image_.rangeOf(static_cast<std::size_t>(next)) < image_.rangeOf(i) - jump_) {
      ++border_.hidden;
    }
    if (height_[i] >= kChest) addUpper(goesOnBeside(i, right));
  }

  void addTop(std::uint32_t i) {
    if (height_[i] < kChest || pieces_.contains(piece_, neighbour(i, -1, 0))) return;
    addUpper(goesOnAbove(i));
  }

  void addUpper(bool flanked) {
    ++border_.upper;
    border_.flanked += flanked ? 1 : 0;
  }

  bool goesOnBeside(std::uint32_t i, int right) const {
    const float step = image_.rangeOf(i) * kTurn / static_cast<float>(image_.columns());
    const int reach = std::max(1, static_cast<int>(kFlankReach / step));
    for (int k = 1; k <= reach; ++k) {
      if (goesOnAt(i, image_.at(image_.rowOf(i), image_.columnOf(i) + right * k))) return true;
    }
    return false;
  }

  bool goesOnAbove(std::uint32_t i) const {
    for (int row = image_.rowOf(i) - 1; row >= 0; --row) {
      const std::int32_t j = image_.at(row, image_.columnOf(i));
      if (j == RangeImage::kNone) continue;
      if (height_[static_cast<std::size_t>(j)] > height_[i] + kFlankReach) return false;
      if (goesOnAt(i, j)) return true;
    }
    return false;
  }

  bool goesOnAt(std::uint32_t i, std::int32_t other) const {
    if (other == RangeImage::kNone || pieces_.contains(piece_, other)) return false;
    const auto j = static_cast<std::size_t>(other);
    return cluster_[j] == piece_.cluster &&
           std::abs(image_.rangeOf(j) - image_.rangeOf(i)) < kFlankDepth;
  }

  const RangeImage& image_;
  const std::vector<float>& height_;
  const std::vector<std::int32_t>& cluster_;
  const ImagePieces& pieces_;
  const ImagePiece& piece_;
  float jump_;
  Border border_;
};

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

/// The most frequent value of the voxel's points, of equally frequent ones the smallest.
std::int32_t majority(const CurvedVoxels& voxels,
                      std::size_t voxel,
                      const std::vector<std::int32_t>& cluster,
                      std::vector<std::int32_t>& scratch) {
  scratch.clear();
  for (std::uint32_t k = voxels.begin[voxel]; k < voxels.begin[voxel + 1]; ++k) {
    scratch.push_back(cluster[voxels.points[k]]);
  }
  std::sort(scratch.begin(), scratch.end());
  std::int32_t best = scratch.front();
  std::ptrdiff_t most = 0;
  for (auto run = scratch.begin(); run != scratch.end();) {
    const auto end = std::upper_bound(run, scratch.end(), *run);
    if (end - run > most) {
      most = end - run;
      best = *run;
    }
    run = end;
  }
  return best;
}

void assignVoxels(const CurvedVoxels& voxels,
                  const std::vector<std::int32_t>& cluster,
                  Clusters& clusters) {
  std::vector<std::int32_t> scratch;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    if (clusters.of_voxel[v] == Clusters::kNoise) continue;
    clusters.of_voxel[v] = majority(voxels, v, cluster, scratch);
  }
}

/// Makes noise of clusters with fewer points, and closes the gaps in their numbers.
void dropSmall(const CurvedVoxels& voxels,
               std::uint32_t n_noise,
               std::size_t count,
               Clusters& clusters) {
  std::vector<std::uint32_t> size(count, 0);
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    const std::int32_t c = clusters.of_voxel[v];
    if (c != Clusters::kNoise) size[static_cast<std::size_t>(c)] += voxels.count(v);
  }
  std::vector<std::int32_t> number(count, Clusters::kNoise);
  clusters.count = 0;
  for (std::size_t c = 0; c < count; ++c) {
    if (size[c] >= n_noise) number[c] = static_cast<std::int32_t>(clusters.count++);
  }
  for (std::int32_t& c : clusters.of_voxel) {
    if (c != Clusters::kNoise) c = number[static_cast<std::size_t>(c)];
  }
}

class Carver {
 public:
  Carver(const std::vector<Point>& points,
         const RangeImage& image,
         const std::vector<float>& height,
         const CarveConfig& config,
         std::vector<std::int32_t>& cluster)
      : points_(points),
        image_(image),
        height_(height),
        config_(config),
        cluster_(cluster),
        pieces_(image, cluster, static_cast<float>(config.jump)) {}

  /// Gives what is carved numbers from `count` on. @returns how many there are then
  std::size_t carve(std::size_t count) {
    std::vector<ImagePiece> candidates =
        pieces_.largerThan(static_cast<std::uint32_t>(config_.min_points));
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [this](const ImagePiece& p) { return !hasSize(p); }),
                     candidates.end());
    const std::vector<ImagePiece> carved = chooseFree(candidates, count);
    std::vector<std::int32_t> result = cluster_;
    for (const ImagePiece& piece : carved) {
      take(piece, static_cast<std::int32_t>(count++), result);
    }
    cluster_ = std::move(result);
    return count;
  }

 private:
  Extent extentOf(const ImagePiece& piece) const {
    Extent extent;
    for (std::uint32_t i : piece.points) {
      extent.footprint.add(points_[i].x, points_[i].y);
      extent.low = std::min(extent.low, height_[i]);
      extent.high = std::max(extent.high, height_[i]);
    }
    return extent;
  }

  bool hasSize(const ImagePiece& piece) const {
    const Extent extent = extentOf(piece);
    const auto top = static_cast<double>(extent.high);
    const auto length = static_cast<double>(extent.footprint.length());
    const auto width = static_cast<double>(extent.footprint.width());
    return top >= config_.top_min && top <= config_.top_max &&
           static_cast<double>(extent.high - extent.low) >= config_.height &&
           length >= config_.length_min && length <= config_.length_max &&
           width <= config_.width_max;
  }

  /// Footprints of the clusters that hold a candidate; the others' stay empty.
  std::vector<Footprint> footprintsOf(const std::vector<ImagePiece>& candidates,
                                      std::size_t clusters) const {
    std::vector<std::uint8_t> wanted(clusters, 0);
    for (const ImagePiece& p : candidates) wanted[static_cast<std::size_t>(p.cluster)] = 1;
    std::vector<Footprint> footprints(clusters);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise) continue;
      const auto c = static_cast<std::size_t>(cluster_[i]);
      if (wanted[c] != 0) footprints[c].add(points_[i].x, points_[i].y);
    }
    return footprints;
  }

  /// Candidates that stand free. What is no larger than a cyclist keeps one of them.
  std::vector<ImagePiece> chooseFree(std::vector<ImagePiece>& candidates,
                                     std::size_t clusters) const {
    const std::vector<Footprint> footprints = footprintsOf(candidates, clusters);
    std::vector<std::size_t> kept(clusters, 0);
    std::vector<ImagePiece> chosen;
    for (ImagePiece& piece : candidates) {
      const auto c = static_cast<std::size_t>(piece.cluster);
      const float length = footprints[c].length();
      const float width = footprints[c].width();
      if (!isFree(piece, length > kVehicleLength || width > kVehicleWidth)) continue;
      if (length <= kCyclistLength && width <= kCyclistWidth && kept[c]++ == 0) continue;
      chosen.push_back(std::move(piece));
    }
    return chosen;
  }

  bool isFree(const ImagePiece& piece, bool beyond_vehicle) const {
    const auto jump = static_cast<float>(config_.jump);
    const Border border = BorderWalk(image_, height_, cluster_, pieces_, piece, jump).walk();
    const auto sides = static_cast<double>(border.sides);
    const double flanked = beyond_vehicle ? config_.flanked_large : config_.flanked;
    return sides >= config_.open * static_cast<double>(piece.points.size()) &&
           static_cast<double>(border.hidden) <= config_.hidden * sides &&
           static_cast<double>(border.flanked) <= flanked * static_cast<double>(border.upper);
  }

  /// Numbers the piece and the fragments of its cluster that lie within it.
  void take(const ImagePiece& piece, std::int32_t number, std::vector<std::int32_t>& result) const {
    const Extent extent = extentOf(piece);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] != piece.cluster || height_[i] > extent.high + kMargin) continue;
      if (2 * pieces_.sizeAt(i) > piece.points.size()) continue;
      if (extent.footprint.contains(points_[i].x, points_[i].y, kMargin)) result[i] = number;
    }
    for (std::uint32_t i : piece.points) result[i] = number;
  }

  const std::vector<Point>& points_;
  const RangeImage& image_;
  const std::vector<float>& height_;
  const CarveConfig& config_;
  std::vector<std::int32_t>& cluster_;  ///< of each point
  ImagePieces pieces_;
};

}  // namespace

void carveClusters(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const Config& config,
                   const CurvedVoxels& voxels,
                   Clusters& clusters) {
  std::vector<std::int32_t> cluster = clusterOfPoints(points.size(), voxels, clusters);
  std::size_t count = clusters.count;
  for (const CarveConfig& kind : {config.person, config.bicycle}) {
    if (kind.jump <= 0.0) continue;
    count = Carver(points, image, height, kind, cluster).carve(count);
  }
  if (count == clusters.count) return;
  assignVoxels(voxels, cluster, clusters);
  dropSmall(voxels, static_cast<std::uint32_t>(config.cvi.n_noise), count, clusters);
}

}  // namespace segdf

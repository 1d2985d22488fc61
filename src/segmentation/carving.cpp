// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/carving.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "segdf/segmentation/horizontal_extent.hpp"
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
// Fragments less than half its size belong to a piece when they stand out of its extent, and
// over its top, by less, metres.
constexpr float kMargin = 0.1F;

/// What a piece borders on.
struct Border {
  std::size_t sides = 0;    ///< points at its left and right border
  std::size_t hidden = 0;   ///< those that lie behind what is beside them
  std::size_t upper = 0;    ///< points at its border from the chest up, its top included
  std::size_t flanked = 0;  ///< those beyond which its cluster goes on
};

/// A piece of the right size, free but for what its cluster's size asks for.
struct Candidate {
  ImagePiece piece;
  Border border;
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
  void addSide(std::uint32_t i, int right) {
    const std::int32_t next = image_.neighbourOf(i, 0, right);
    if (pieces_.contains(piece_, next)) return;
    ++border_.sides;
    if (next != RangeImage::kNone &&
        image_.rangeOf(static_cast<std::size_t>(next)) < image_.rangeOf(i) - jump_) {
      ++border_.hidden;
    }
    if (height_[i] >= kChest) addUpper(goesOnBeside(i, right));
  }

  void addTop(std::uint32_t i) {
    if (height_[i] < kChest || pieces_.contains(piece_, image_.neighbourOf(i, -1, 0))) return;
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

/// The most frequent value, of equally frequent ones the smallest.
std::int32_t mostFrequent(std::vector<std::int32_t>& values) {
  std::sort(values.begin(), values.end());
  std::int32_t best = values.front();
  std::ptrdiff_t most = 0;
  for (auto run = values.begin(); run != values.end();) {
    const auto end = std::upper_bound(run, values.end(), *run);
    if (end - run > most) best = *run;
    most = std::max(most, end - run);
    run = end;
  }
  return best;
}

void assignVoxels(const CurvedVoxels& voxels,
                  const std::vector<std::int32_t>& cluster,
                  Clusters& clusters) {
  std::vector<std::int32_t> values;
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    values.clear();
    bool changed = false;
    for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
      values.push_back(cluster[voxels.points[k]]);
      changed = changed || values.back() != clusters.of_voxel[v];
    }
    if (changed) clusters.of_voxel[v] = mostFrequent(values);
  }
}

class Carver {
 public:
  Carver(const std::vector<Point>& points,
         const RangeImage& image,
         const std::vector<float>& height,
         const CarveConfig& config,
         const ImagePieces& pieces,
         std::vector<std::int32_t>& cluster)
      : points_(points),
        image_(image),
        height_(height),
        config_(config),
        pieces_(pieces),
        cluster_(cluster) {}

  /// Gives what is carved numbers from `count` on. @returns how many there are then
  std::size_t carve(std::size_t count) {
    const std::vector<ImagePiece> carved = choose(findCandidates(), count);
    std::vector<std::int32_t> result = cluster_;
    for (const ImagePiece& piece : carved) {
      take(piece, static_cast<std::int32_t>(count++), result);
    }
    cluster_ = std::move(result);
    return count;
  }

 private:
  /// What costs least is asked first: few pieces have the height of a person.
  bool hasSize(const ImagePiece& piece) const {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::uint32_t i : piece.points) {
      low = std::min(low, height_[i]);
      high = std::max(high, height_[i]);
    }
    const auto top = static_cast<double>(high);
    if (top < config_.top_min || top > config_.top_max) return false;
    if (static_cast<double>(high - low) < config_.height) return false;
    const HorizontalExtent extent = extentOf(piece.points);
    const auto length = static_cast<double>(extent.length());
    return length >= config_.length_min && length <= config_.length_max &&
           static_cast<double>(extent.width()) <= config_.width_max;
  }

  HorizontalExtent extentOf(const std::vector<std::uint32_t>& indices) const {
    HorizontalExtent extent;
    for (std::uint32_t i : indices) extent.add(points_[i].x, points_[i].y);
    return extent;
  }

  /// Footprints of the clusters that hold a candidate; the others' stay empty.
  std::vector<HorizontalExtent> extentsOf(const std::vector<Candidate>& candidates,
                                          std::size_t clusters) const {
    std::vector<std::uint8_t> wanted(clusters, 0);
    for (const Candidate& c : candidates) wanted[static_cast<std::size_t>(c.piece.cluster)] = 1;
    std::vector<HorizontalExtent> extents(clusters);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] == Clusters::kNoise) continue;
      const auto c = static_cast<std::size_t>(cluster_[i]);
      if (wanted[c] != 0) extents[c].add(points_[i].x, points_[i].y);
    }
    return extents;
  }

  /// Pieces of the right size that stand free, if their cluster is large.
  std::vector<Candidate> findCandidates() const {
    const auto jump = static_cast<float>(config_.jump);
    std::vector<Candidate> candidates;
    for (ImagePiece& piece : pieces_.largerThan(static_cast<std::uint32_t>(config_.min_points))) {
      if (!hasSize(piece)) continue;
      const Border border = BorderWalk(image_, height_, cluster_, pieces_, piece, jump).walk();
      if (isOpen(border, piece.points.size()) && !goesOn(border, config_.flanked_large)) {
        candidates.push_back({std::move(piece), border});
      }
    }
    return candidates;
  }

  bool isOpen(const Border& border, std::size_t points) const {
    const auto sides = static_cast<double>(border.sides);
    return sides >= config_.open * static_cast<double>(points) &&
           static_cast<double>(border.hidden) <= config_.hidden * sides;
  }

  static bool goesOn(const Border& border, double limit) {
    return static_cast<double>(border.flanked) > limit * static_cast<double>(border.upper);
  }

  /// What is no larger than a cyclist keeps one of its candidates.
  std::vector<ImagePiece> choose(std::vector<Candidate> candidates, std::size_t clusters) const {
    std::vector<ImagePiece> chosen;
    if (candidates.empty()) return chosen;
    const std::vector<HorizontalExtent> extents = extentsOf(candidates, clusters);
    std::vector<std::size_t> kept(clusters, 0);
    for (Candidate& candidate : candidates) {
      const auto c = static_cast<std::size_t>(candidate.piece.cluster);
      const float length = extents[c].length();
      const float width = extents[c].width();
      const bool large = length > kVehicleLength || width > kVehicleWidth;
      if (!large && goesOn(candidate.border, config_.flanked)) continue;
      if (length <= kCyclistLength && width <= kCyclistWidth && kept[c]++ == 0) continue;
      chosen.push_back(std::move(candidate.piece));
    }
    return chosen;
  }

  /// Numbers the piece and the fragments of its cluster that lie within it.
  void take(const ImagePiece& piece, std::int32_t number, std::vector<std::int32_t>& result) const {
    const HorizontalExtent extent = extentOf(piece.points);
    float top = -std::numeric_limits<float>::infinity();
    for (std::uint32_t i : piece.points) top = std::max(top, height_[i]);
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (cluster_[i] != piece.cluster || height_[i] > top + kMargin) continue;
      if (std::size_t{2} * pieces_.sizeAt(i) > piece.points.size()) continue;
      if (extent.contains(points_[i].x, points_[i].y, kMargin)) result[i] = number;
    }
    for (std::uint32_t i : piece.points) result[i] = number;
  }

  const std::vector<Point>& points_;
  const RangeImage& image_;
  const std::vector<float>& height_;
  const CarveConfig& config_;
  const ImagePieces& pieces_;           ///< of `cluster_`
  std::vector<std::int32_t>& cluster_;  ///< of each point
};

}  // namespace

void carveClusters(const std::vector<Point>& points,
                   const RangeImage& image,
                   const std::vector<float>& height,
                   const Config& config,
                   const CurvedVoxels& voxels,
                   Clusters& clusters) {
  const CarveConfig& person = config.person;
  const CarveConfig& bicycle = config.bicycle;
  if (person.jump <= 0.0 && bicycle.jump <= 0.0) return;
  std::vector<std::int32_t> cluster = clusterOfPoints(points.size(), voxels, clusters);
  std::size_t count = clusters.count;
  ImagePieces pieces(image, cluster, static_cast<float>(person.jump),
                     static_cast<float>(bicycle.jump));
  if (person.jump > 0.0)
    count = Carver(points, image, height, person, pieces, cluster).carve(count);
  if (bicycle.jump > 0.0) {
    pieces.proceed(cluster);
    count = Carver(points, image, height, bicycle, pieces, cluster).carve(count);
  }
  if (count == clusters.count) return;
  assignVoxels(voxels, cluster, clusters);
  clusters.count = count;
  dropSmallClusters(voxels, static_cast<std::uint32_t>(config.cvi.n_noise), clusters);
}

}  // namespace segdf

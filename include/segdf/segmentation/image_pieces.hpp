// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/segmentation/range_image.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

/// Part of a cluster.
struct ImagePiece {
  std::uint32_t root = 0;             ///< its smallest point
  std::int32_t cluster = 0;           ///< that it belongs to
  std::vector<std::uint32_t> points;  ///< indices into the scan, ascending
};

/// Neighbours in the range image, of one cluster.
struct ImageLink {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// The pieces that clusters fall into where neighbours in the range image differ by more than
/// `jump` metres in range, and then by more than `next_jump`: most of the second partition is the
/// first one.
class ImagePieces {
 public:
  /// @param image must live as long as this
  /// @param cluster of each point, Clusters::kNoise for those in none
  ImagePieces(const RangeImage& image,
              const std::vector<std::int32_t>& cluster,
              float jump,
              float next_jump);

  /// Makes them the pieces for `next_jump`.
  /// @param cluster as in the constructor, but that parts of clusters may be new ones
  void proceed(const std::vector<std::int32_t>& cluster);

  /// Number of points in the piece of a point; 0 for a point in no cluster.
  std::uint32_t sizeAt(std::size_t point) const { return size_[root_[point]]; }
  /// True when `point` (kNone when there is none) belongs to the piece.
  bool contains(const ImagePiece& piece, std::int32_t point) const {
    return point != RangeImage::kNone && root_[static_cast<std::size_t>(point)] == piece.root;
  }
  /// Pieces of so many points or more that are not their whole cluster, by smallest point.
  std::vector<ImagePiece> largerThan(std::uint32_t min_points) const;

 private:
  /// For each cluster, whether its pieces do not follow from those there are.
  std::vector<std::uint8_t> findStale(const std::vector<std::int32_t>& cluster) const;
  void count();

  const RangeImage& image_;
  float jump_;
  float next_jump_;
  std::vector<std::int32_t> cluster_;
  UnionFind pieces_;
  std::vector<ImageLink> next_links_;        ///< from `jump` up to `next_jump`
  std::vector<std::uint32_t> members_;       ///< the points in clusters, ascending
  std::vector<std::uint32_t> root_;          ///< of each point
  std::vector<std::uint32_t> size_;          ///< of each root's piece
  std::vector<std::uint32_t> cluster_size_;  ///< points
};

}  // namespace segdf

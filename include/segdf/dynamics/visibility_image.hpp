// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// What a scan says of a place (method.md 6.4).
enum class VolumetricState : std::uint8_t {
  kUnknown,   ///< nothing looked there, or the answers differ
  kHit,       ///< something returned from there
  kFree,      ///< every ray around went past it
  kOccluded,  ///< the rays end before it
};

/// Spherical image of all points of one scan, ground included: the nearest and the farthest range
/// in each bin. Rows span the elevations that the scan has, columns the full turn.
class VisibilityImage {
 public:
  /// Used points (role not kUnused) enter. @throws nothing; a scan without points gives an image
  /// that knows nothing
  VisibilityImage(const std::vector<Point>& points,
                  const std::vector<PointRole>& roles,
                  const DynamicConfig& config);

  /// States of places. HIT when a bin within the margin df.margin has its nearest or farthest
  /// return within the tolerance max(df.tau, df.tau_ratio r) of range r; FREE when every non-empty
  /// bin there begins behind the tolerance, and not all of its rays are above the place: a dark car
  /// far away returns nothing, and the rays over its roof go past; OCCLUDED when at least half of
  /// the bins begin before it.
  /// @param places in any frame, a row each, metres
  /// @param image_T_places takes them into the sensor frame of this scan
  /// @param[out] states one for each place
  void look(const Eigen::Ref<const Eigen::MatrixX3f>& places,
            const Eigen::Isometry3f& image_T_places,
            VolumetricState* states) const;

 private:
  using Centimetres = std::int16_t;
  /// Margins of up to this many columns are prepared.
  static constexpr int kLevels = 4;

  /// Places that are worked on together.
  static constexpr int kBlock = 64;
  /// Where places of a block lie, in bins from the corner of the image; the half width of their
  /// margins in bins; their ranges, metres.
  struct Block {
    std::array<float, kBlock> row;
    std::array<float, kBlock> column;
    std::array<float, kBlock> margin;
    std::array<float, kBlock> range;
  };
  struct Bin {
    int row = 0;
    int column = 0;
    std::uint8_t level = 0;  ///< up to which a ray in this row is not above the place
  };
  struct Window {
    int rows = 0;     ///< half, in bins
    int columns = 0;  ///< half, in bins
  };

  /// For each bin its nearest return and its farthest, that one negative: so the bounds of several
  /// bins are the least of theirs, and lie side by side in memory, which the images are too large
  /// to be kept near in.
  using Bounds = std::vector<Centimetres>;
  /// The bounds of the window around each bin.
  struct Level {
    Window window;
    Bounds bounds;
  };

  Block project(const Eigen::Ref<const Eigen::MatrixX3f>& places,
                const Eigen::Isometry3f& image_T_places) const;
  /// True for places that the scan may say something of; NaN is outside.
  bool isInside(const Block& block, std::size_t k) const;
  Bin binOf(const Block& block, std::size_t k) const;
  /// Half the width of its margin.
  static int columnsOf(const Block& block, std::size_t k) {
    return std::max(1, static_cast<int>(std::ceil(block.margin[k])));
  }
  /// Asks the memory for what stateOf will read: the images do not fit the processor's cache.
  void fetch(const Block& block, std::size_t k) const;
  VolumetricState stateOf(const Block& block, std::size_t k) const;
  Window windowOf(int columns) const;
  void fill(const std::vector<Point>& points, const std::vector<PointRole>& roles);
  /// Repeats columns at both sides.
  void wrap();
  void prepareLevels();
  Bounds boundsAround(const Window& window) const;
  static int nearestOf(const Bounds& bounds, std::size_t bin) { return bounds[2 * bin]; }
  static int farthestOf(const Bounds& bounds, std::size_t bin) { return -bounds[2 * bin + 1]; }
  bool isSeen(std::size_t bin) const;
  /// FREE when every ray around went past, unless all of these are above the place: UNKNOWN.
  VolumetricState stateOfPassed(const Bin& bin, const Window& window) const;
  bool returnsBelow(const Bin& bin, const Window& window) const;
  VolumetricState search(const Bin& bin, const Window& window, int near, int far) const;
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(column + pad_);
  }

  float tau_;
  float tau_ratio_;
  float margin_;
  float row_step_;     // rad
  float column_step_;  // rad
  float lowest_ = 0.0F;
  int rows_ = 0;
  int columns_ = 0;
  int pad_ = 0;  // columns repeated on both sides, so that a window never wraps
  int stride_ = 0;
  Bounds bounds_;
  std::vector<std::uint8_t> lowest_level_;  // of the returns in each bin
  std::array<Level, kLevels> levels_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/scan.hpp"
#include "segdf/segmentation/moments.hpp"

namespace segdf {

/// Level of the ground as a plane. Metres, sensor frame.
struct GroundPlane {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double level = 0.0;  ///< at the centre

  double heightOf(const Point& p) const {
    const Eigen::Vector2d way =
        Eigen::Vector2d(static_cast<double>(p.x), static_cast<double>(p.y)) - center;
    return static_cast<double>(p.z) - level - slope.dot(way);
  }
};

/// The ground points in a square of 1 m.
struct GroundCell {
  Moments moments;
  bool listed = false;
  std::vector<std::uint32_t> points;  ///< when listed
};

/// Ground points by cells, of those cells that are asked for.
class GroundCells {
 public:
  /// @param areas to be asked for, none empty
  /// @param listed parts of them of which single points are asked for
  GroundCells(const std::vector<Eigen::AlignedBox2f>& areas,
              const std::vector<Eigen::AlignedBox2f>& listed);

  /// @param point its index in the scan
  void add(const Point& p, std::uint32_t point);

  /// Calls visit(cell) for the cells that an area, or part of one, touches.
  template <class Visit>
  void forEachCell(const Eigen::AlignedBox2f& area, const Visit& visit) const {
    forEachIndex(area,
                 [&](std::size_t index) { visit(cells_[static_cast<std::size_t>(slot_[index])]); });
  }

 private:
  static constexpr std::int32_t kUnused = -1;

  static int cell(float at, float least) { return static_cast<int>(at - least); }

  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  template <class Visit>
  void forEachIndex(const Eigen::AlignedBox2f& area, const Visit& visit) const {
    const Eigen::Vector2f least = all_.min();
    for (int row = cell(area.min().x(), least.x()); row <= cell(area.max().x(), least.x()); ++row) {
      for (int column = cell(area.min().y(), least.y()); column <= cell(area.max().y(), least.y());
           ++column) {
        visit(index(row, column));
      }
    }
  }

  Eigen::AlignedBox2f all_;
  int rows_ = 0;
  int columns_ = 0;
  std::vector<std::int32_t> slot_;  ///< of each square, kUnused for those in no area
  std::vector<GroundCell> cells_;
};

/// Through the ground in the cells that an area touches, but not in a hole in it, by least squares
/// in height; none where there is too little ground.
/// @param points of the scan
std::optional<GroundPlane> planeAround(const std::vector<Point>& points,
                                       const GroundCells& cells,
                                       const Eigen::AlignedBox2f& area,
                                       const Eigen::AlignedBox2f& hole);

}  // namespace segdf

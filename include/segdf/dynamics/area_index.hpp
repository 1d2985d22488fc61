// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// The used points of a scan by their place seen from above, in square cells, so that what lies
/// around an object is found without a walk over the whole scan.
class AreaIndex {
 public:
  AreaIndex(const std::vector<Point>& points, const std::vector<PointRole>& roles);

  /// Points in the area (sensor frame, metres), borders included; cell by cell, ascending in each.
  std::vector<std::uint32_t> pointsIn(const Eigen::AlignedBox2f& area) const;

 private:
  static constexpr int kSide = 64;      // cells; what is farther out is in those at the border
  static constexpr float kCell = 4.0F;  // metres

  static int cellAt(float coordinate);
  static std::size_t cellOf(const Point& p);

  const std::vector<Point>& points_;
  std::vector<std::uint32_t> begin_;  // of each cell, in order_
  std::vector<std::uint32_t> order_;
};

}  // namespace segdf

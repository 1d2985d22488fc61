// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/arc_tangent.hpp"

#include <cstddef>

namespace segdf {

std::vector<double> turnsOf(const std::vector<Point>& points) {
  // Coordinates one after the other are what compilers make several at a time of.
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    x[i] = static_cast<double>(points[i].x);
    y[i] = static_cast<double>(points[i].y);
  }
  std::vector<double> turns(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) turns[i] = turnOf(y[i], x[i]);
  return turns;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "segdf/simulation/centre_line.hpp"
#include "segdf/simulation/route.hpp"

namespace segdf {

/// Rectangle on the ground, seen from above.
struct GroundRectangle {
  Place place;          ///< its middle and heading
  double length = 1.0;  ///< along the heading, metres
  double width = 1.0;   ///< metres
};

/// True when two rectangles share some ground.
bool overlap(const GroundRectangle& a, const GroundRectangle& b);

/// The ground that is taken: rectangles, and the lanes of those who will pass.
class TakenGround {
 public:
  /// Takes the rectangle.
  void add(const GroundRectangle& footprint);
  /// Takes what the user's footprint sweeps over on the first `way` metres of the route.
  void addLane(const Route& route, double way, const GroundRectangle& user);
  /// True when the rectangle, grown by `margin` metres on each side, touches nothing taken.
  bool isFree(const GroundRectangle& footprint, double margin) const;

 private:
  using Cell = std::pair<int, int>;

  std::map<Cell, std::vector<GroundRectangle>>
      cells_;  // each rectangle in every cell that it touches
};

}  // namespace segdf

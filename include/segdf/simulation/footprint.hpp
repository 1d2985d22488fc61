// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "segdf/simulation/centre_line.hpp"
#include "segdf/simulation/route.hpp"

namespace segdf {

/// Rectangle on the ground, seen from above.
struct Footprint {
  Place place;          ///< its middle and heading
  double length = 1.0;  ///< along the heading, metres
  double width = 1.0;   ///< metres
};

/// True when two rectangles share some ground.
bool overlap(const Footprint& a, const Footprint& b);

/// The ground that is taken: rectangles, and the lanes of those who will pass.
class TakenGround {
 public:
  /// Takes the rectangle.
  void add(const Footprint& footprint);
  /// Takes what the user's footprint sweeps over on the first `way` metres of the route.
  void addLane(const Route& route, double way, const Footprint& user);
  /// True when the rectangle, grown by `margin` metres on each side, touches nothing taken.
  bool isFree(const Footprint& footprint, double margin) const;

 private:
  using Cell = std::pair<int, int>;

  std::map<Cell, std::vector<Footprint>> cells_;  // each rectangle in every cell that it touches
};

}  // namespace segdf

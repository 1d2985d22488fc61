// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "segdf/simulation/centre_line.hpp"

namespace segdf {

/// The way that something takes: a polyline in street coordinates with rounded corners, so that
/// "along the lane" follows the street's bends.
class Route {
 public:
  /// @param corners at least one; a single one is a place to stand at
  /// @param rounding metres before and after each corner that the turn takes
  Route(const CentreLine& line, const std::vector<StreetPoint>& corners, double rounding);

  double length() const { return ways_.back(); }
  /// Place after `way` metres; its ends beyond its length.
  Place at(double way) const;
  /// Fastest speed at `way` with which the turns ahead and a stop at the end can be met, m/s.
  double speedAt(double way) const;
  /// First way at which the street coordinate `along` is passed, going forward or backward;
  /// negative when it never is.
  double wayWherePassed(double along, bool forward) const;

  const std::vector<Place>& places() const { return places_; }

 private:
  void addPoint(const CentreLine& line, const StreetPoint& point);
  void setHeadings(double only_heading);
  void setSpeeds();
  std::size_t indexAt(double way) const;

  std::vector<StreetPoint> points_;
  std::vector<Place> places_;
  std::vector<double> ways_;    // metres, of each place
  std::vector<double> speeds_;  // m/s, of each place
};

}  // namespace segdf

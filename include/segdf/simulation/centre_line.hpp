// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace segdf {

/// A point of the street: `along` its centre line, `across` to the left of it. Metres.
struct StreetPoint {
  double along = 0.0;
  double across = 0.0;
};

/// Position (metres, map frame) and heading (rad).
struct Place {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;
};

/// Where the centre line turns.
struct Bend {
  double at = 0.0;       ///< metres along, where the bend begins
  double angle = 0.0;    ///< rad, to the left when positive
  double radius = 40.0;  ///< metres

  double length() const;
};

/// Centre line of a street: from the origin along x, straight but for its bends, and straight on
/// before its begin and after its end.
class CentreLine {
 public:
  CentreLine() : CentreLine(std::vector<Bend>{}) {}
  /// @throws std::invalid_argument when bends overlap or do not come in order
  explicit CentreLine(const std::vector<Bend>& bends);

  /// Map frame place of a street point; its yaw is the street's heading.
  Place place(const StreetPoint& point) const;
  /// Street point of a map frame position, by the nearest point of the centre line.
  StreetPoint nearest(double x, double y) const;

 private:
  struct Piece {
    double from = 0.0;       ///< metres along
    double to = 0.0;         ///< metres along
    double curvature = 0.0;  ///< 1/m, 0 = straight
    Place start;
  };

  static StreetPoint nearestOn(const Piece& piece, double x, double y);

  std::vector<Piece> pieces_;
};

}  // namespace segdf

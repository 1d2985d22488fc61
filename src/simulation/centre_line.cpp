// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/centre_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace segdf {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFar = 1e5;  // metres that the line goes on before its begin and after its end

Place advance(const Place& start, double curvature, double way) {
  if (curvature == 0.0) {
    return {start.x + way * std::cos(start.yaw), start.y + way * std::sin(start.yaw), start.yaw};
  }
  const double yaw = start.yaw + curvature * way;
  return {start.x + (std::sin(yaw) - std::sin(start.yaw)) / curvature,
          start.y - (std::cos(yaw) - std::cos(start.yaw)) / curvature, yaw};
}

}  // namespace

double Bend::length() const { return std::abs(angle) * radius; }

CentreLine::CentreLine(const std::vector<Bend>& bends) {
  Piece piece;
  piece.from = -kFar;
  piece.start = {-kFar, 0.0, 0.0};
  for (const Bend& bend : bends) {
    if (bend.at < piece.from) {
      std::ostringstream text;
      text << "the bend at " << bend.at << " m begins before the one in front of it ends";
      throw std::invalid_argument(text.str());
    }
    piece.to = bend.at;
    pieces_.push_back(piece);
    Piece arc;
    arc.from = bend.at;
    arc.to = bend.at + bend.length();
    arc.curvature = std::copysign(1.0 / bend.radius, bend.angle);
    arc.start = advance(piece.start, 0.0, piece.to - piece.from);
    pieces_.push_back(arc);
    piece.from = arc.to;
    piece.start = advance(arc.start, arc.curvature, bend.length());
  }
  piece.to = kFar;
  pieces_.push_back(piece);
}

Place CentreLine::place(const StreetPoint& point) const {
  const auto piece =
      std::find_if(pieces_.begin(), pieces_.end() - 1,
                   [&point](const Piece& candidate) { return candidate.to >= point.along; });
  Place place = advance(piece->start, piece->curvature, point.along - piece->from);
  place.x -= point.across * std::sin(place.yaw);
  place.y += point.across * std::cos(place.yaw);
  return place;
}

StreetPoint CentreLine::nearestOn(const Piece& piece, double x, double y) {
  const double length = piece.to - piece.from;
  double way = 0.0;
  if (piece.curvature == 0.0) {
    way = (x - piece.start.x) * std::cos(piece.start.yaw) +
          (y - piece.start.y) * std::sin(piece.start.yaw);
  } else {
    const double radius = 1.0 / piece.curvature;
    const double cx = piece.start.x - radius * std::sin(piece.start.yaw);
    const double cy = piece.start.y + radius * std::cos(piece.start.yaw);
    const double sign = piece.curvature > 0.0 ? 1.0 : -1.0;
    const double turned = std::atan2(sign * (y - cy), sign * (x - cx)) + kPi / 2.0;
    way = std::remainder(turned - piece.start.yaw, 2.0 * kPi) / piece.curvature;
  }
  way = std::clamp(way, 0.0, length);
  const Place foot = advance(piece.start, piece.curvature, way);
  const double dx = x - foot.x;
  const double dy = y - foot.y;
  const double side = std::cos(foot.yaw) * dy - std::sin(foot.yaw) * dx;
  return {piece.from + way, std::copysign(std::hypot(dx, dy), side)};
}

StreetPoint CentreLine::nearest(double x, double y) const {
  StreetPoint best{0.0, std::numeric_limits<double>::infinity()};
  for (const Piece& piece : pieces_) {
    const StreetPoint candidate = nearestOn(piece, x, y);
    if (std::abs(candidate.across) < std::abs(best.across)) best = candidate;
  }
  return best;
}

}  // namespace segdf

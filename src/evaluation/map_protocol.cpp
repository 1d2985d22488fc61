// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/map_protocol.hpp"

#include <stdexcept>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

namespace {

double rangeOf(const Point& point) { return point.position().cast<double>().norm(); }

}  // namespace

void MapProtocol::add(const Scan& scan, const std::vector<std::uint32_t>& truth) {
  if (truth.size() != scan.points.size()) {
    throw std::invalid_argument("points and labels differ in number");
  }
  std::vector<Eigen::Vector3f> places;
  std::vector<std::size_t> scored;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (semantic_kitti::isIgnored(semantic_kitti::classOf(truth[i]))) continue;
    // Not "range > limit": a NaN coordinate is not within the range either.
    if (!(rangeOf(scan.points[i]) <= range_)) continue;
    scored.push_back(i);
    places.push_back(inMapFrame(scan.pose, scan.points[i]));
  }
  const std::vector<std::uint8_t> kept = map_.haveWithin(places, kTolerance, threads_);
  for (std::size_t k = 0; k < scored.size(); ++k) {
    scores_.add(truth[scored[k]], rangeOf(scan.points[scored[k]]), kept[k] != 0);
  }
}

Eigen::Vector3f inMapFrame(const Pose& map_T_sensor, const Point& point) {
  return (map_T_sensor * point.position().cast<double>()).cast<float>();
}

}  // namespace segdf

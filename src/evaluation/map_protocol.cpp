// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/map_protocol.hpp"

#include <stdexcept>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

void MapProtocol::add(const Scan& scan, const std::vector<std::uint32_t>& truth) {
  if (truth.size() != scan.points.size()) {
    throw std::invalid_argument("points and labels differ in number");
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double range = scan.points[i].position().cast<double>().norm();
    // Not "range > limit": a NaN coordinate is not within the range either.
    if (!(range <= range_) || semantic_kitti::isIgnored(semantic_kitti::classOf(truth[i]))) {
      continue;
    }
    const Eigen::Vector3f place = inMapFrame(scan.pose, scan.points[i]);
    scores_.add(truth[i], range, map_.hasWithin(place, tolerance_));
  }
}

Eigen::Vector3f inMapFrame(const Pose& map_T_sensor, const Point& point) {
  return (map_T_sensor * point.position().cast<double>()).cast<float>();
}

}  // namespace segdf

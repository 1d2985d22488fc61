// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/mapping/static_map.hpp"

#include <cmath>
#include <stdexcept>

namespace segdf {

std::size_t StaticMap::KeyHash::operator()(const Eigen::Vector3i& key) const {
  // Three large primes mix the coordinates; only look-ups depend on it, never the order of the
  // output.
  const auto x = static_cast<std::size_t>(key.x());
  const auto y = static_cast<std::size_t>(key.y());
  const auto z = static_cast<std::size_t>(key.z());
  return (x * 73856093U) ^ (y * 19349669U) ^ (z * 83492791U);
}

StaticMap::StaticMap(double voxel) : voxel_(voxel) {
  if (!(voxel > 0.0)) throw std::invalid_argument("the map's voxel must be above 0 m");
}

void StaticMap::add(const FrameResult& frame) {
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (!isKept(frame.labels[i].state)) continue;
    add(toMapPoint(frame.scan.points[i], frame.scan.pose, frame.labels[i]));
  }
}

void StaticMap::add(const MapPoint& point) {
  const Eigen::Vector3d position(static_cast<double>(point.x), static_cast<double>(point.y),
                                 static_cast<double>(point.z));
  const Eigen::Vector3i key = (position / voxel_).array().floor().cast<int>();
  if (index_.emplace(key, points_.size()).second) points_.push_back(point);
}

void StaticMap::clear() {
  index_.clear();
  points_.clear();
}

std::vector<MapPoint> thinned(const std::vector<MapPoint>& points, double voxel) {
  if (voxel == 0.0) return points;
  if (!std::isfinite(voxel)) throw std::invalid_argument("the map's voxel must be finite");
  StaticMap coarse(voxel);
  for (const MapPoint& point : points) coarse.add(point);
  return coarse.points();
}

}  // namespace segdf

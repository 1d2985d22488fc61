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
    add(toMapPoint(frame.scan.points[i], frame.scan.pose, frame.labels[i]), frame.index);
  }
}

Eigen::Vector3i StaticMap::keyOf(const MapPoint& point) const {
  const Eigen::Vector3d position(static_cast<double>(point.x), static_cast<double>(point.y),
                                 static_cast<double>(point.z));
  return (position / voxel_).array().floor().cast<int>();
}

void StaticMap::add(const MapPoint& point, std::size_t scan) {
  if (!occupied_.insert(keyOf(point)).second) return;
  points_.push_back(point);
  scans_.push_back(static_cast<std::uint32_t>(scan));
}

std::vector<MapPoint> StaticMap::revoke(const Revocation& revocation) {
  std::vector<MapPoint> revoked;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (isRevoked(points_[k], scans_[k], revocation)) {
      occupied_.erase(keyOf(points_[k]));
      revoked.push_back(points_[k]);
      continue;
    }
    points_[kept] = points_[k];
    scans_[kept++] = scans_[k];
  }
  points_.resize(kept);
  scans_.resize(kept);
  return revoked;
}

void StaticMap::clear() {
  occupied_.clear();
  points_.clear();
  scans_.clear();
}

std::vector<MapPoint> thinned(const std::vector<MapPoint>& points, double voxel) {
  if (voxel == 0.0) return points;
  if (!std::isfinite(voxel)) throw std::invalid_argument("the map's voxel must be finite");
  StaticMap coarse(voxel);
  for (const MapPoint& point : points) coarse.add(point);
  return coarse.points();
}

}  // namespace segdf

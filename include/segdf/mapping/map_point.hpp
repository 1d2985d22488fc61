// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/core/label.hpp"
#include "segdf/core/scan.hpp"

namespace segdf {

/// One point of the map, as static_map.pcd and dynamic_points.pcd hold it.
struct MapPoint {
  float x = 0.0F;          ///< metres, map frame
  float y = 0.0F;          ///< metres, map frame
  float z = 0.0F;          ///< metres, map frame
  float intensity = 0.0F;  ///< as the sensor gave it
  std::uint32_t label =
      0;  ///< SemanticKITTI-style class (core/semantic_kitti.hpp), without instance
  std::uint32_t instance = 0;  ///< global instance id, whole; 0 = none
};

/// Takes a judged point of a scan into the map frame.
MapPoint toMapPoint(const Point& point, const Pose& map_T_sensor, const PointLabel& label);

/// The points of a frame whose state is wanted, in their order. @param wanted true or false for a
/// PointState
template <class Wanted>
std::vector<MapPoint> mapPointsWhere(const FrameResult& frame, const Wanted& wanted) {
  std::vector<MapPoint> points;
  points.reserve(frame.labels.size());
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (!wanted(frame.labels[i].state)) continue;
    points.push_back(toMapPoint(frame.scan.points[i], frame.scan.pose, frame.labels[i]));
  }
  return points;
}

/// True for a point that what is revoked left in the map. @param scan that the point came with
inline bool isRevoked(const MapPoint& point, std::size_t scan, const Revocation& revocation) {
  return point.instance == revocation.id && scan >= revocation.first && scan <= revocation.last;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

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

}  // namespace segdf

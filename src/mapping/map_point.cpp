// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/mapping/map_point.hpp"

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

MapPoint toMapPoint(const Point& point, const Pose& map_T_sensor, const PointLabel& label) {
  const Eigen::Vector3f x = (map_T_sensor * point.position().cast<double>()).cast<float>();
  return {x.x(),
          x.y(),
          x.z(),
          point.intensity,
          semantic_kitti::classOf(semantic_kitti::encode(label)),
          label.instance};
}

}  // namespace segdf

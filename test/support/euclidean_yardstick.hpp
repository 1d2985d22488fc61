// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf::test {

/// What segmentation is measured against, in speed and in quality: PCL's VoxelGrid (0.1 m) and
/// EuclideanClusterExtraction (0.5 m, 5 voxels and more) over the points that are not ground.
struct EuclideanClusters {
  pcl::PointCloud<pcl::PointXYZ>::Ptr thinned;  ///< centroids of the voxels
  std::vector<std::int32_t> of_thinned;         ///< cluster of each centroid, -1 = none
};

pcl::PointCloud<pcl::PointXYZ>::Ptr objectCloud(const std::vector<Point>& points,
                                                const std::vector<PointRole>& roles);

EuclideanClusters clusterEuclidean(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud);

/// Cluster of each point of the scan, that of the nearest centroid; -1 = none.
std::vector<std::int32_t> clusterOfPoints(const EuclideanClusters& clusters,
                                          const std::vector<Point>& points,
                                          const std::vector<PointRole>& roles);

}  // namespace segdf::test

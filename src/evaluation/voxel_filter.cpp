// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/voxel_filter.hpp"

#include <cmath>

namespace segdf {

namespace {

std::vector<Eigen::Vector3f> centroidsOf(const PointGrid& grid) {
  std::vector<Eigen::Vector3f> centroids;
  centroids.reserve(grid.cells().size());
  for (const PointGrid::Cell& cell : grid.cells()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t i = cell.begin; i < cell.end; ++i) sum += grid.sortedPoint(i).cast<double>();
    centroids.emplace_back((sum / (cell.end - cell.begin)).cast<float>());
  }
  return centroids;
}

}  // namespace

void ClassedPoints::append(const ClassedPoints& other) {
  points.insert(points.end(), other.points.begin(), other.points.end());
  classes.insert(classes.end(), other.classes.begin(), other.classes.end());
}

std::vector<Eigen::Vector3f> voxelCentroids(const std::vector<Eigen::Vector3f>& points,
                                            double leaf) {
  return centroidsOf(PointGrid(points, leaf));
}

ClassedPoints voxelFilter(const ClassedPoints& cloud, double leaf) {
  const PointGrid grid(cloud.points, leaf);
  ClassedPoints voxels;
  voxels.points = centroidsOf(grid);
  voxels.classes.reserve(voxels.points.size());
  // A centroid's own voxel holds a point, so one is found within the diagonal.
  const double diagonal = 1.001 * std::sqrt(3.0) * leaf;
  for (const Eigen::Vector3f& centroid : voxels.points) {
    voxels.classes.push_back(cloud.classes[grid.nearest(centroid, diagonal)->index]);
  }
  return voxels;
}

}  // namespace segdf

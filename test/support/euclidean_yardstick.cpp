// SPDX-License-Identifier: BSD-3-Clause
#include "support/euclidean_yardstick.hpp"

#include <cstddef>

#include <pcl/filters/voxel_grid.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

namespace segdf::test {

namespace {

constexpr float kLeaf = 0.1F;       // m
constexpr double kTolerance = 0.5;  // m
constexpr int kMinVoxels = 5;

}  // namespace

pcl::PointCloud<pcl::PointXYZ>::Ptr objectCloud(const std::vector<Point>& points,
                                                const std::vector<PointRole>& roles) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kObject) cloud->push_back({points[i].x, points[i].y, points[i].z});
  }
  return cloud;
}

EuclideanClusters clusterEuclidean(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud) {
  EuclideanClusters result;
  result.thinned.reset(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(kLeaf, kLeaf, kLeaf);
  grid.filter(*result.thinned);
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(result.thinned);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(kTolerance);
  extraction.setMinClusterSize(kMinVoxels);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(result.thinned);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  result.of_thinned.assign(result.thinned->size(), -1);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const auto i : clusters[c].indices) {
      result.of_thinned[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(c);
    }
  }
  return result;
}

std::vector<std::int32_t> clusterOfPoints(const EuclideanClusters& clusters,
                                          const std::vector<Point>& points,
                                          const std::vector<PointRole>& roles) {
  std::vector<std::int32_t> of_point(points.size(), -1);
  if (clusters.thinned->empty()) return of_point;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(clusters.thinned);
  pcl::Indices nearest(1);
  std::vector<float> distance(1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] != PointRole::kObject) continue;
    tree.nearestKSearch({points[i].x, points[i].y, points[i].z}, 1, nearest, distance);
    of_point[i] = clusters.of_thinned[static_cast<std::size_t>(nearest.front())];
  }
  return of_point;
}

}  // namespace segdf::test

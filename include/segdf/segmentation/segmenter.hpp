// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/curved_voxels.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

/// Seg(P_k) of formula (3), before classification: ground, clusters and noise of one scan.
struct Segmentation {
  std::vector<PointRole> roles;      ///< one for each point
  std::vector<float> height;         ///< over the local ground, metres
  std::vector<std::int32_t> row;     ///< laser counted from the topmost, -1 for unused points
  std::vector<std::int32_t> column;  ///< azimuth bin, -1 for unused points
  std::vector<Surface> surfaces;     ///< of object points
  CurvedVoxels voxels;               ///< of object points
  Clusters clusters;
  std::vector<Segment> segments;  ///< segment s is cluster s; box, features and class still empty
  std::size_t non_finite_points = 0;

  /// Gives back the memory of row, column and surfaces, for when all segments are described.
  void forgetSurfaces() {
    // Assigned empty braces, a vector would keep its memory.
    row = std::vector<std::int32_t>();
    column = std::vector<std::int32_t>();
    surfaces = std::vector<Surface>();
  }
  /// Gives back that of voxels and clusters, for when no other scan is laid over this one any more.
  void forgetVoxels() {
    voxels = {};
    clusters = {};
  }
};

/// Which points take part: finite, within range, not on the own vehicle. The others are kUnused.
std::vector<PointRole> selectPoints(const std::vector<Point>& points, const InputConfig& config);

/// Gives clusters that may be vehicles (`config.vehicle`) what is seen behind their face, and their
/// feet, and the ground under them to the ground. Wants roles, height, voxels and clusters. Linear
/// in points.
void completeVehicles(const Scan& scan,
                      const RangeImage& image,
                      const Config& config,
                      const CurvedGrid& grid,
                      Segmentation& seg);

/// Algorithm 1, one scan. @param times gets the seconds of ground, normals and clustering
Segmentation segmentScan(const Scan& scan, const Config& config, int threads, StageTimes& times);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/core/segment.hpp"

namespace segdf {

/// What the features are computed from: parallel arrays over the points of one scan.
struct PointAttributes {
  const std::vector<Point>& points;
  const std::vector<float>& height;         ///< over the local ground, metres
  const std::vector<std::int32_t>& row;     ///< laser counted from the topmost
  const std::vector<std::int32_t>& column;  ///< azimuth bin
  const std::vector<Surface>& surfaces;
};

/// Smallest upright rectangle around the points (3 degree steps), with their lowest and highest z.
/// Box centre and size in metres, sensor frame. An empty list gives an empty box at the origin.
UprightBox fitBox(const std::vector<Point>& points, const std::vector<std::uint32_t>& indices);

/// The 17 eigenvalue features (method.md 5.1). With l1 >= l2 >= l3 the eigenvalues of the
/// population covariance, e their shares of the sum, v the eigenvectors: (l1-l2)/l1, (l2-l3)/l1,
/// l3/l1, (e1 e2 e3)^(1/3), (l1-l3)/l1, -sum e ln e, e3, l1+l2+l3 [m^2], 1-|v3z|, |v1z|, sum and
/// ratio (small over large) of the eigenvalues in the xy plane, mean |d.v1| and mean |d.v2| over
/// offsets d from the mean [m], mean local change of curvature, share of normals with |nz| < 0.35,
/// share of points with local change of curvature < 0.02. All are 0 for a cluster without extent.
///
/// The 13 scale features (method.md 5.2): 2 % and 98 % quantile of the height over ground [m],
/// height [m], length [m], width [m], length/width, length*width [m^2], length*width*height [m^3],
/// horizontal range [m], log10 of the point count, points per m^2 of length*width + length*height,
/// share of azimuth columns whose highest point lies in the top 3 lasers, share of footprint cells
/// (0.3 m) whose lowest point is less than 0.3 m above ground.
///
/// Roughness: median distance, along the ray, of a point from the line between its neighbours to
/// the left and right [m], 0 where that is known of fewer than 10 points (docs/segmentation.md).
///
/// Sets segment.box and segment.features; every value is finite.
void describeSegment(const PointAttributes& attributes, Segment& segment);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace segdf {

/// First and second moments of offsets from a point near them all, which keeps sums exact.
struct Moments {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  void add(double x, double y, double z) {
    count += 1.0;
    sum += Eigen::Vector3d(x, y, z);
    xx += x * x;
    xy += x * y;
    xz += x * z;
    yy += y * y;
    yz += y * z;
    zz += z * z;
  }
  /// Adds offsets from the same point, or with -1 takes away those that were added.
  void add(const Moments& other, double times = 1.0) {
    count += times * other.count;
    sum += times * other.sum;
    xx += times * other.xx;
    xy += times * other.xy;
    xz += times * other.xz;
    yy += times * other.yy;
    yz += times * other.yz;
    zz += times * other.zz;
  }
  /// Mean offset; there must be a point.
  Eigen::Vector3d mean() const { return sum / count; }
  /// Population covariance; there must be a point.
  Eigen::Matrix3d covariance() const;
};

/// Eigenvalues of a symmetric matrix without negative ones, ascending.
Eigen::Vector3d eigenvaluesOf(const Eigen::Matrix3d& matrix);

/// Unit eigenvector for a simple eigenvalue of a symmetric matrix; zero when the eigenvalue is not
/// simple, so that no direction is determined.
Eigen::Vector3d eigenvectorOf(const Eigen::Matrix3d& matrix, double eigenvalue);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/moments.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace segdf {

namespace {

constexpr int kMaxSteps = 16;
constexpr double kPrecision = 1e-7;  // of the trace

/// Sum of the principal minors of order 2: second coefficient of the characteristic polynomial.
double minorSum(const Eigen::Matrix3d& m) {
  return m(0, 0) * m(1, 1) - m(0, 1) * m(0, 1) + m(0, 0) * m(2, 2) - m(0, 2) * m(0, 2) +
         m(1, 1) * m(2, 2) - m(1, 2) * m(1, 2);
}

}  // namespace

Eigen::Matrix3d Moments::covariance() const {
  const Eigen::Vector3d m = mean();
  Eigen::Matrix3d c;
  c << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return c / count - m * m.transpose();
}

Eigen::Vector3d eigenvaluesOf(const Eigen::Matrix3d& m) {
  const double trace = m.trace();
  if (!(trace > 0.0)) return Eigen::Vector3d::Zero();
  const double minors = minorSum(m);
  const double det = m.determinant();
  // Newton's method from 0 climbs to the smallest root and never passes it: the polynomial falls
  // and is convex up to there.
  double smallest = 0.0;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double value = ((trace - smallest) * smallest - minors) * smallest + det;
    const double slope = (2.0 * trace - 3.0 * smallest) * smallest - minors;
    if (!(value > 0.0) || !(slope < 0.0)) break;
    const double way = -value / slope;
    smallest += way;
    if (way < kPrecision * trace) break;
  }
  // The other two solve a quadratic equation.
  const double sum = trace - smallest;
  const double product = minors - smallest * sum;
  const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product));
  return {smallest, std::max(smallest, (sum - root) / 2.0), (sum + root) / 2.0};
}

Eigen::Vector3d eigenvectorOf(const Eigen::Matrix3d& matrix, double eigenvalue) {
  Eigen::Matrix3d m = matrix;
  m.diagonal().array() -= eigenvalue;
  // The eigenvector stands on every row; of the three products of rows the longest is the surest.
  const Eigen::Vector3d a = m.row(0).cross(m.row(1));
  const Eigen::Vector3d b = m.row(1).cross(m.row(2));
  const Eigen::Vector3d c = m.row(2).cross(m.row(0));
  Eigen::Vector3d best = a;
  if (b.squaredNorm() > best.squaredNorm()) best = b;
  if (c.squaredNorm() > best.squaredNorm()) best = c;
  const double length = best.norm();
  const double scale = matrix.trace();
  if (!(length > 1e-12 * scale * scale)) return Eigen::Vector3d::Zero();
  return best / length;
}

}  // namespace segdf

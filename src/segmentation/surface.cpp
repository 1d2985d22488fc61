// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>

#include <Eigen/Eigenvalues>

#include "segdf/core/parallel.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

namespace {

constexpr int kHalfRows = 2;
constexpr int kHalfColumns = 4;
constexpr int kMinNeighbours = 6;
// A normal is trusted when the neighbourhood is flat, and no line (method.md 3.6).
constexpr float kMaxCurvature = 0.05F;
constexpr float kMinWidth = 0.005F;
constexpr std::size_t kGrain = 2048;

/// First and second moments of offsets from the point itself.
struct Moments {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  Eigen::Matrix3f products = Eigen::Matrix3f::Zero();
  int count = 0;

  void add(const Eigen::Vector3f& offset) {
    sum += offset;
    products += offset * offset.transpose();
    ++count;
  }
  Eigen::Matrix3d covariance() const {
    const double n = count;
    const Eigen::Vector3d mean = sum.cast<double>() / n;
    return products.cast<double>() / n - mean * mean.transpose();
  }
};

Moments neighbourhood(const std::vector<Point>& points,
                      const RangeImage& image,
                      std::size_t i,
                      const RangeImageConfig& config) {
  const float range = image.rangeOf(i);
  const float gate =
      std::max(static_cast<float>(config.gate), static_cast<float>(config.gate_ratio) * range);
  const Eigen::Vector3f origin = points[i].position();
  Moments moments;
  for (int dr = -kHalfRows; dr <= kHalfRows; ++dr) {
    for (int dc = -kHalfColumns; dc <= kHalfColumns; ++dc) {
      const std::int32_t j = image.at(image.rowOf(i) + dr, image.columnOf(i) + dc);
      if (j == RangeImage::kNone) continue;
      const auto neighbour = static_cast<std::size_t>(j);
      if (std::abs(image.rangeOf(neighbour) - range) > gate) continue;
      moments.add(points[neighbour].position() - origin);
    }
  }
  return moments;
}

Surface surfaceAt(const std::vector<Point>& points,
                  const RangeImage& image,
                  std::size_t i,
                  const RangeImageConfig& config) {
  Surface surface;
  const Moments moments = neighbourhood(points, image, i, config);
  if (moments.count < kMinNeighbours) return surface;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  const Eigen::Vector3f values = solver.eigenvalues().cwiseMax(0.0).cast<float>();
  const float sum = values.sum();
  if (!(sum > 0.0F)) return surface;
  surface.curvature = values[0] / sum;
  if (surface.curvature < kMaxCurvature && values[1] / sum > kMinWidth) {
    const Eigen::Vector3f normal = solver.eigenvectors().col(0).cast<float>();
    surface.normal = normal.dot(points[i].position()) > 0.0F ? Eigen::Vector3f(-normal) : normal;
  }
  return surface;
}

}  // namespace

std::vector<Surface> estimateSurfaces(const std::vector<Point>& points,
                                      const std::vector<PointRole>& roles,
                                      const RangeImage& image,
                                      const RangeImageConfig& config,
                                      int threads) {
  std::vector<Surface> surfaces(points.size());
  parallelBlocks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (roles[i] == PointRole::kObject) surfaces[i] = surfaceAt(points, image, i, config);
    }
  });
  return surfaces;
}

}  // namespace segdf

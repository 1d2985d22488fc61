// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Eigenvalues>

#include "segdf/segmentation/moments.hpp"

namespace segdf {

namespace {

using Indices = std::vector<std::uint32_t>;

constexpr double kNoExtent = 1e-9;        // m^2
constexpr float kVerticalNormal = 0.35F;  // |nz| of a wall
constexpr float kSmoothCurvature = 0.02F;
constexpr std::int32_t kTopRows = 3;
constexpr float kFootprintCell = 0.3F;         // m
constexpr float kMaxFootprintCells = 1000.0F;  // along a side; a larger segment has larger cells
constexpr float kContactHeight = 0.6F;         // m
constexpr std::size_t kRoughPoints = 10;
constexpr float kLowQuantile = 0.02F;
constexpr float kHighQuantile = 0.98F;
constexpr float kSmallLength = 0.01F;  // m; keeps ratios finite

void setEigenvalueShapes(const Eigen::Vector3d& l, FeatureVector& f) {
  const double sum = l.sum();
  const Eigen::Vector3d e = l / sum;
  double entropy = 0.0;
  for (int k = 0; k < 3; ++k) entropy -= e[k] > 0.0 ? e[k] * std::log(e[k]) : 0.0;
  f[Feature::kLinearity] = static_cast<float>((l[0] - l[1]) / l[0]);
  f[Feature::kPlanarity] = static_cast<float>((l[1] - l[2]) / l[0]);
  f[Feature::kScattering] = static_cast<float>(l[2] / l[0]);
  f[Feature::kOmnivariance] = static_cast<float>(std::cbrt(e.prod()));
  f[Feature::kAnisotropy] = static_cast<float>((l[0] - l[2]) / l[0]);
  f[Feature::kEigenentropy] = static_cast<float>(entropy);
  f[Feature::kCurvatureChange] = static_cast<float>(e[2]);
  f[Feature::kEigenvalueSum] = static_cast<float>(sum);
}

void setPlanarEigenvalues(const Eigen::Matrix3d& covariance, FeatureVector& f) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(covariance.topLeftCorner<2, 2>(), Eigen::EigenvaluesOnly);
  const Eigen::Vector2d values = solver.eigenvalues().cwiseMax(0.0);
  f[Feature::kEigenvalueSum2d] = static_cast<float>(values.sum());
  f[Feature::kEigenvalueRatio2d] =
      values[1] > kNoExtent ? static_cast<float>(values[0] / values[1]) : 0.0F;
}

void setMoments(const std::vector<Point>& points,
                const Indices& indices,
                const Eigen::Vector3d& mean,
                const Eigen::Matrix3d& axes,
                FeatureVector& f) {
  double first = 0.0;
  double second = 0.0;
  for (std::uint32_t i : indices) {
    const Eigen::Vector3d offset = points[i].position().cast<double>() - mean;
    first += std::abs(offset.dot(axes.col(2)));
    second += std::abs(offset.dot(axes.col(1)));
  }
  const auto n = static_cast<double>(indices.size());
  f[Feature::kMomentFirstAxis] = static_cast<float>(first / n);
  f[Feature::kMomentSecondAxis] = static_cast<float>(second / n);
}

void setEigenvalueBlock(const std::vector<Point>& points,
                        const Indices& indices,
                        FeatureVector& f) {
  const Eigen::Vector3d origin = points[indices.front()].position().cast<double>();
  Moments moments;
  for (std::uint32_t i : indices) {
    const Eigen::Vector3d offset = points[i].position().cast<double>() - origin;
    moments.add(offset.x(), offset.y(), offset.z());
  }
  const Eigen::Matrix3d covariance = moments.covariance();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d values = solver.eigenvalues().reverse().cwiseMax(0.0);
  if (!(values.sum() > kNoExtent)) return;
  setEigenvalueShapes(values, f);
  f[Feature::kVerticality] = static_cast<float>(1.0 - std::abs(solver.eigenvectors().col(0).z()));
  f[Feature::kMainAxisZ] = static_cast<float>(std::abs(solver.eigenvectors().col(2).z()));
  setPlanarEigenvalues(covariance, f);
  setMoments(points, indices, origin + moments.mean(), solver.eigenvectors(), f);
}

void setLocalShares(const std::vector<Surface>& surfaces,
                    const Indices& indices,
                    FeatureVector& f) {
  float curvature = 0.0F;
  int known = 0;
  int smooth = 0;
  int normals = 0;
  int vertical = 0;
  for (std::uint32_t i : indices) {
    const Surface& surface = surfaces[i];
    if (surface.curvature >= 0.0F) {
      ++known;
      curvature += surface.curvature;
      smooth += surface.curvature < kSmoothCurvature ? 1 : 0;
    }
    if (surface.hasNormal()) {
      ++normals;
      vertical += std::abs(surface.normal.z()) < kVerticalNormal ? 1 : 0;
    }
  }
  const auto share = [](int part, int whole) {
    return whole > 0 ? static_cast<float>(part) / static_cast<float>(whole) : 0.0F;
  };
  f[Feature::kLocalCurvature] = known > 0 ? curvature / static_cast<float>(known) : 0.0F;
  f[Feature::kSmoothShare] = share(smooth, known);
  f[Feature::kVerticalShare] = share(vertical, normals);
}

/// The median of what is known; 0 where it is known of too few to tell.
float roughness(const std::vector<Surface>& surfaces, const Indices& indices) {
  std::vector<float> known;
  known.reserve(indices.size());
  for (std::uint32_t i : indices) {
    if (surfaces[i].roughness >= 0.0F) known.push_back(surfaces[i].roughness);
  }
  if (known.size() < kRoughPoints) return 0.0F;
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return *middle;
}

void setHeights(const std::vector<float>& height, const Indices& indices, FeatureVector& f) {
  std::vector<float> heights;
  heights.reserve(indices.size());
  for (std::uint32_t i : indices) heights.push_back(height[i]);
  const auto quantile = [&heights](float share) {
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<float>(heights.size() - 1));
    std::nth_element(heights.begin(), heights.begin() + k, heights.end());
    return heights[static_cast<std::size_t>(k)];
  };
  f[Feature::kBottom] = quantile(kLowQuantile);
  f[Feature::kTop] = quantile(kHighQuantile);
}

void setBoxFeatures(const Segment& segment, FeatureVector& f) {
  const Eigen::Vector3f& size = segment.box.size;
  const auto n = static_cast<float>(segment.points.size());
  const float visible = size.x() * size.y() + size.x() * size.z();
  f[Feature::kHeight] = size.z();
  f[Feature::kLength] = size.x();
  f[Feature::kWidth] = size.y();
  f[Feature::kElongation] = size.x() / std::max(size.y(), kSmallLength);
  f[Feature::kFootprint] = size.x() * size.y();
  f[Feature::kVolume] = size.prod();
  f[Feature::kRange] = segment.box.center.head<2>().norm();
  f[Feature::kLogCount] = std::log10(n);
  f[Feature::kDensity] = n / std::max(visible, kSmallLength);
}

/// Share of azimuth columns that the top edge of the field of view cuts.
float topcut(const PointAttributes& a, const Indices& indices) {
  const auto [first, last] = std::minmax_element(
      indices.begin(), indices.end(),
      [&](std::uint32_t i, std::uint32_t j) { return a.column[i] < a.column[j]; });
  constexpr std::int32_t kEmpty = std::numeric_limits<std::int32_t>::max();
  const std::int32_t offset = a.column[*first];
  std::vector<std::int32_t> highest(static_cast<std::size_t>(a.column[*last] - offset) + 1, kEmpty);
  for (std::uint32_t i : indices) {
    std::int32_t& row = highest[static_cast<std::size_t>(a.column[i] - offset)];
    row = std::min(row, a.row[i]);
  }
  const auto columns =
      std::count_if(highest.begin(), highest.end(), [](std::int32_t row) { return row != kEmpty; });
  const auto cut = std::count_if(highest.begin(), highest.end(),
                                 [](std::int32_t row) { return row < kTopRows; });
  return static_cast<float>(cut) / static_cast<float>(columns);
}

/// Share of footprint cells that reach down to the ground.
float groundContact(const PointAttributes& a, const Segment& segment) {
  const Eigen::Vector2f low = segment.bounds.min().head<2>();
  const Eigen::Vector2f extent = segment.bounds.sizes().head<2>();
  const float side = std::max(kFootprintCell, extent.maxCoeff() / kMaxFootprintCells);
  const auto columns = static_cast<std::size_t>(extent.x() / side) + 1;
  const auto rows = static_cast<std::size_t>(extent.y() / side) + 1;
  constexpr float kEmpty = std::numeric_limits<float>::infinity();
  std::vector<float> lowest(columns * rows, kEmpty);
  for (std::uint32_t i : segment.points) {
    const auto column = static_cast<std::size_t>((a.points[i].x - low.x()) / side);
    const auto row = static_cast<std::size_t>((a.points[i].y - low.y()) / side);
    float& cell = lowest[std::min(column, columns - 1) * rows + std::min(row, rows - 1)];
    cell = std::min(cell, a.height[i]);
  }
  const auto total =
      std::count_if(lowest.begin(), lowest.end(), [](float height) { return height != kEmpty; });
  const auto contact = std::count_if(lowest.begin(), lowest.end(),
                                     [](float height) { return height < kContactHeight; });
  return static_cast<float>(contact) / static_cast<float>(total);
}

}  // namespace

void describeSegment(const PointAttributes& attributes, Segment& segment) {
  segment.box = fitBox(attributes.points, segment.points);
  segment.features = FeatureVector{};
  if (segment.points.empty()) return;
  FeatureVector& f = segment.features;
  segment.bounds.setEmpty();
  for (std::uint32_t i : segment.points) segment.bounds.extend(attributes.points[i].position());
  setEigenvalueBlock(attributes.points, segment.points, f);
  setLocalShares(attributes.surfaces, segment.points, f);
  setHeights(attributes.height, segment.points, f);
  setBoxFeatures(segment, f);
  f[Feature::kTopcut] = topcut(attributes, segment.points);
  f[Feature::kGroundContact] = groundContact(attributes, segment);
  f[Feature::kRoughness] = roughness(attributes.surfaces, segment.points);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/classification/features.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>

namespace segdf {

namespace {

using Indices = std::vector<std::uint32_t>;

constexpr double kNoExtent = 1e-9;        // m^2
constexpr float kVerticalNormal = 0.35F;  // |nz| of a wall
constexpr float kSmoothCurvature = 0.02F;
constexpr std::int32_t kTopRows = 3;
constexpr float kFootprintCell = 0.3F;  // m
constexpr float kContactHeight = 0.6F;  // m
constexpr float kLowQuantile = 0.02F;
constexpr float kHighQuantile = 0.98F;
constexpr float kSmallLength = 0.01F;  // m; keeps ratios finite

struct Distribution {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

Distribution distributionOf(const std::vector<Point>& points, const Indices& indices) {
  Distribution d;
  const auto n = static_cast<double>(indices.size());
  for (std::uint32_t i : indices) d.mean += points[i].position().cast<double>();
  d.mean /= n;
  for (std::uint32_t i : indices) {
    const Eigen::Vector3d offset = points[i].position().cast<double>() - d.mean;
    d.covariance += offset * offset.transpose();
  }
  d.covariance /= n;
  return d;
}

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
  const Distribution d = distributionOf(points, indices);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(d.covariance);
  const Eigen::Vector3d values = solver.eigenvalues().reverse().cwiseMax(0.0);
  if (!(values.sum() > kNoExtent)) return;
  setEigenvalueShapes(values, f);
  f[Feature::kVerticality] = static_cast<float>(1.0 - std::abs(solver.eigenvectors().col(0).z()));
  f[Feature::kMainAxisZ] = static_cast<float>(std::abs(solver.eigenvectors().col(2).z()));
  setPlanarEigenvalues(d.covariance, f);
  setMoments(points, indices, d.mean, solver.eigenvectors(), f);
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
  std::vector<std::pair<std::int32_t, std::int32_t>> cells;
  cells.reserve(indices.size());
  for (std::uint32_t i : indices) cells.emplace_back(a.column[i], a.row[i]);
  std::sort(cells.begin(), cells.end());
  int columns = 0;
  int cut = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k > 0 && cells[k].first == cells[k - 1].first) continue;
    ++columns;  // the first of a column is its highest
    cut += cells[k].second < kTopRows ? 1 : 0;
  }
  return static_cast<float>(cut) / static_cast<float>(columns);
}

/// Share of footprint cells that reach down to the ground.
float groundContact(const PointAttributes& a, const Indices& indices) {
  std::vector<std::tuple<float, float, float>> cells;
  cells.reserve(indices.size());
  for (std::uint32_t i : indices) {
    cells.emplace_back(std::floor(a.points[i].x / kFootprintCell),
                       std::floor(a.points[i].y / kFootprintCell), a.height[i]);
  }
  std::sort(cells.begin(), cells.end());
  int total = 0;
  int contact = 0;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const auto& [x, y, lowest] = cells[k];
    if (k > 0 && x == std::get<0>(cells[k - 1]) && y == std::get<1>(cells[k - 1])) continue;
    ++total;
    contact += lowest < kContactHeight ? 1 : 0;
  }
  return static_cast<float>(contact) / static_cast<float>(total);
}

}  // namespace

void describeSegment(const PointAttributes& attributes, Segment& segment) {
  segment.box = fitBox(attributes.points, segment.points);
  segment.features = FeatureVector{};
  if (segment.points.empty()) return;
  FeatureVector& f = segment.features;
  setEigenvalueBlock(attributes.points, segment.points, f);
  setLocalShares(attributes.surfaces, segment.points, f);
  setHeights(attributes.height, segment.points, f);
  setBoxFeatures(segment, f);
  f[Feature::kTopcut] = topcut(attributes, segment.points);
  f[Feature::kGroundContact] = groundContact(attributes, segment.points);
}

}  // namespace segdf

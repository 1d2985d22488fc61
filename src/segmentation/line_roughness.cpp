// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/line_roughness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "segdf/core/parallel.hpp"
#include "segdf/segmentation/clustering.hpp"

namespace segdf {

namespace {

constexpr std::size_t kGrain = 4096;
constexpr float kUnknown = -1.0F;

float cross(const Eigen::Vector2f& a, const Eigen::Vector2f& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The next return of the row, kNone when it is of another cluster.
std::int32_t neighbourOf(std::size_t i,
                         int side,
                         const RangeImage& image,
                         const std::vector<std::int32_t>& cluster) {
  const std::int32_t j = image.neighbourOf(i, 0, side);
  const bool same = j != RangeImage::kNone && cluster[static_cast<std::size_t>(j)] == cluster[i];
  return same ? j : RangeImage::kNone;
}

/// Where the ray to p meets the line through a and b, on either side of it, against where p is.
float distanceAlongRay(const Point& p, const Point& a, const Point& b) {
  const Eigen::Vector2f from(a.x, a.y);
  const Eigen::Vector2f along = Eigen::Vector2f(b.x, b.y) - from;
  const Eigen::Vector2f at(p.x, p.y);
  const float range = at.norm();
  const float width = cross(at / range, along);
  const float met = cross(from, along) / width;
  const auto [near, far] = std::minmax({from.norm(), (from + along).norm()});
  // Seen along the line, it is met anywhere: no nearer than one end and no farther than the other.
  return std::isfinite(met) ? std::abs(range - std::clamp(met, near, far)) : kUnknown;
}

}  // namespace

void measureRoughness(const std::vector<Point>& points,
                      const RangeImage& image,
                      const std::vector<std::int32_t>& cluster,
                      int threads,
                      std::vector<Surface>& surfaces) {
  const auto roughness_of = [&](std::size_t i) {
    if (cluster[i] == Clusters::kNoise) return kUnknown;
    const std::int32_t left = neighbourOf(i, -1, image, cluster);
    const std::int32_t right = neighbourOf(i, 1, image, cluster);
    if (left == RangeImage::kNone || right == RangeImage::kNone) return kUnknown;
    return distanceAlongRay(points[i], points[static_cast<std::size_t>(left)],
                            points[static_cast<std::size_t>(right)]);
  };
  parallelBlocks(points.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) surfaces[i].roughness = roughness_of(i);
  });
}

}  // namespace segdf

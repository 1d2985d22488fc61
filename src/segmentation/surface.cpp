// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "segdf/core/parallel.hpp"
#include "segdf/segmentation/moments.hpp"
#include "segdf/segmentation/range_image.hpp"

namespace segdf {

namespace {

constexpr std::size_t kHalfRows = 2;
constexpr std::size_t kHalfColumns = 4;
constexpr float kMinNeighbours = 6.0F;
// A normal is trusted when the neighbourhood is flat, and no line (method.md 3.6).
constexpr double kMaxCurvature = 0.05;
constexpr double kMinWidth = 0.005;
// Centres worked on at once: as many floats as fit the registers of every processor.
constexpr std::size_t kLanes = 4;
// Rows worked on by one thread: small enough for the processor's cache.
constexpr int kBandRows = 8;
// Range of an empty cell, far from any gate.
constexpr float kEmptyRange = -1e9F;

// Turns what is left of the gate into a weight of 0 or 1.
constexpr float kSteepness = 1e9F;

using Lane = Eigen::Array<float, kLanes, 1>;

/// Every second column of some rows of the range image, as plain arrays.
struct Comb {
  std::vector<float> x, y, z, range;

  explicit Comb(std::size_t size)
      : x(size, 0.0F), y(size, 0.0F), z(size, 0.0F), range(size, kEmptyRange) {}
};

/// Some rows of the range image, even and odd columns apart, so that every second cell's
/// neighbours lie side by side; with a rim of neighbouring rows and of wrapped columns, so that
/// windows need no bounds.
struct Band {
  std::size_t stride;
  std::array<Comb, 2> combs;

  Band(const std::vector<Point>& points, const RangeImage& image, int first_row, int rows);

  /// Of a cell in an even column; row counted from the band's first.
  std::size_t at(std::size_t row, std::size_t column) const {
    return (row + kHalfRows) * stride + (column + kHalfColumns) / 2;
  }
};

Band::Band(const std::vector<Point>& points, const RangeImage& image, int first_row, int rows)
    : stride(static_cast<std::size_t>(image.columns()) / 2 + kHalfColumns + kLanes + 1),
      combs{Comb((static_cast<std::size_t>(rows) + 2 * kHalfRows) * stride),
            Comb((static_cast<std::size_t>(rows) + 2 * kHalfRows) * stride)} {
  const int rim = static_cast<int>(kHalfColumns);
  const std::size_t places = static_cast<std::size_t>(image.columns()) + 2 * kHalfColumns;
  std::size_t line = 0;
  for (int row = first_row - static_cast<int>(kHalfRows); line < combs[0].x.size();
       ++row, line += stride) {
    for (std::size_t place = 0; place < places; ++place) {
      const std::int32_t i = image.at(row, static_cast<int>(place) - rim);
      if (i == RangeImage::kNone) continue;
      Comb& comb = combs[place % 2];
      const std::size_t cell = line + place / 2;
      const Point& p = points[static_cast<std::size_t>(i)];
      comb.x[cell] = p.x;
      comb.y[cell] = p.y;
      comb.z[cell] = p.z;
      comb.range[cell] = image.rangeOf(static_cast<std::size_t>(i));
    }
  }
}

/// Moments of the windows around kLanes cells, every second of a row.
struct LaneMoments {
  Lane n = Lane::Zero(), x = n, y = n, z = n, xx = n, xy = n, xz = n, yy = n, yz = n, zz = n;

  Moments at(Eigen::Index lane) const {
    const auto wide = [lane](const Lane& values) { return static_cast<double>(values[lane]); };
    Moments m;
    m.count = wide(n);
    m.sum = {wide(x), wide(y), wide(z)};
    m.xx = wide(xx);
    m.xy = wide(xy);
    m.xz = wide(xz);
    m.yy = wide(yy);
    m.yz = wide(yz);
    m.zz = wide(zz);
    return m;
  }
};

/// Greatest difference in range of neighbours, metres.
float gateAt(float range, const RangeImageConfig& config) {
  return std::max(static_cast<float>(config.gate), static_cast<float>(config.gate_ratio) * range);
}

LaneMoments windowMoments(const Band& band, std::size_t centre, const RangeImageConfig& config) {
  const auto load = [](const std::vector<float>& values, std::size_t cell) {
    return Lane(Lane::Map(values.data() + cell));
  };
  const Lane x0 = load(band.combs[0].x, centre);
  const Lane y0 = load(band.combs[0].y, centre);
  const Lane z0 = load(band.combs[0].z, centre);
  const Lane range0 = load(band.combs[0].range, centre);
  const Lane gate = (static_cast<float>(config.gate_ratio) * range0)
                        .max(Lane::Constant(static_cast<float>(config.gate)));
  const std::size_t corner = centre - kHalfRows * band.stride - kHalfColumns / 2;
  LaneMoments m;
  for (std::size_t row = 0; row <= 2 * kHalfRows; ++row) {
    for (std::size_t column = 0; column <= 2 * kHalfColumns; ++column) {
      const Comb& comb = band.combs[column % 2];
      const std::size_t cell = corner + row * band.stride + column / 2;
      // 1 inside the gate and 0 outside, without a branch.
      const Lane inside = (gate - (load(comb.range, cell) - range0).abs()) * kSteepness;
      const Lane w = inside.max(Lane::Zero()).min(Lane::Ones());
      const Lane dx = w * (load(comb.x, cell) - x0);
      const Lane dy = w * (load(comb.y, cell) - y0);
      const Lane dz = w * (load(comb.z, cell) - z0);
      m.n += w;
      m.x += dx;
      m.y += dy;
      m.z += dz;
      m.xx += dx * dx;
      m.xy += dx * dy;
      m.xz += dx * dz;
      m.yy += dy * dy;
      m.yz += dy * dz;
      m.zz += dz * dz;
    }
  }
  return m;
}

Surface surfaceFrom(const Moments& moments, const Point& point) {
  Surface surface;
  if (moments.count < static_cast<double>(kMinNeighbours)) return surface;
  const Eigen::Matrix3d covariance = moments.covariance();
  const Eigen::Vector3d values = eigenvaluesOf(covariance);
  const double sum = values.sum();
  if (!(sum > 0.0)) return surface;
  surface.curvature = static_cast<float>(values[0] / sum);
  if (values[0] / sum < kMaxCurvature && values[1] / sum > kMinWidth) {
    const Eigen::Vector3f normal = eigenvectorOf(covariance, values[0]).cast<float>();
    surface.normal = normal.dot(point.position()) > 0.0F ? Eigen::Vector3f(-normal) : normal;
  }
  return surface;
}

void describeBand(const std::vector<Point>& points,
                  const std::vector<PointRole>& roles,
                  const RangeImage& image,
                  const RangeImageConfig& config,
                  int first_row,
                  std::vector<Surface>& surfaces) {
  const int rows = std::min(kBandRows, image.rows() - first_row);
  const Band band(points, image, first_row, rows);
  const auto wanted = [&](int row, int column) {
    const std::int32_t i = column < image.columns() ? image.at(row, column) : RangeImage::kNone;
    const bool is_object =
        i != RangeImage::kNone && roles[static_cast<std::size_t>(i)] == PointRole::kObject;
    return is_object ? i : RangeImage::kNone;
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < image.columns(); column += 2 * static_cast<int>(kLanes)) {
      std::array<std::int32_t, kLanes> centres{};
      for (int l = 0; l < static_cast<int>(kLanes); ++l) {
        centres[static_cast<std::size_t>(l)] = wanted(first_row + row, column + 2 * l);
      }
      if (*std::max_element(centres.begin(), centres.end()) == RangeImage::kNone) continue;
      const std::size_t cell =
          band.at(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
      const LaneMoments moments = windowMoments(band, cell, config);
      for (std::size_t l = 0; l < kLanes; ++l) {
        if (centres[l] == RangeImage::kNone) continue;
        const auto i = static_cast<std::size_t>(centres[l]);
        surfaces[i] = surfaceFrom(moments.at(static_cast<Eigen::Index>(l)), points[i]);
      }
    }
  }
}

/// Gives the other object points the surface of a described cell, their own or one beside it, when
/// they lie on it: points of odd columns, and those behind the nearest of a cell.
void shareSurfaces(const std::vector<PointRole>& roles,
                   const RangeImage& image,
                   const RangeImageConfig& config,
                   std::vector<Surface>& surfaces) {
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != PointRole::kObject) continue;
    const int row = image.rowOf(i);
    const int column = image.columnOf(i);
    const bool described = column % 2 == 0;
    if (described && image.at(row, column) == static_cast<std::int32_t>(i)) continue;
    float nearest = gateAt(image.rangeOf(i), config);
    for (int beside = described ? 0 : -1; beside <= (described ? 0 : 1); beside += 2) {
      const std::int32_t shown = image.at(row, column + beside);
      if (shown == RangeImage::kNone) continue;
      const auto k = static_cast<std::size_t>(shown);
      const float away = std::abs(image.rangeOf(i) - image.rangeOf(k));
      if (roles[k] != PointRole::kObject || away > nearest) continue;
      nearest = away;
      surfaces[i] = surfaces[k];
    }
  }
}

}  // namespace

std::vector<Surface> estimateSurfaces(const std::vector<Point>& points,
                                      const std::vector<PointRole>& roles,
                                      const RangeImage& image,
                                      const RangeImageConfig& config,
                                      int threads) {
  std::vector<Surface> surfaces(points.size());
  const int bands = (image.rows() + kBandRows - 1) / kBandRows;
  parallelFor(static_cast<std::size_t>(bands), threads, [&](std::size_t band) {
    const int first_row = static_cast<int>(band) * kBandRows;
    describeBand(points, roles, image, config, first_row, surfaces);
  });
  shareSurfaces(roles, image, config, surfaces);
  return surfaces;
}

}  // namespace segdf

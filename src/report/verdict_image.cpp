// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/verdict_image.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "segdf/core/quantile.hpp"

namespace segdf {

namespace {

constexpr double kFinest = 0.05;         // metres a pixel
constexpr double kLongestSide = 1600.0;  // pixels
constexpr double kMargin = 3.0;          // metres
constexpr double kLeftOut = 0.003;       // of the points at each side
constexpr double kBrightest = 40.0;      // points in a pixel
constexpr VerdictColour kGround{16, 18, 22};

/// The range of one coordinate without its outermost points: lone returns from far away would leave
/// most of the picture empty.
std::pair<double, double> middleOf(const std::vector<Eigen::Vector3f>& points, int axis) {
  if (points.empty()) return {0.0, 0.0};
  std::vector<float> values;
  values.reserve(points.size());
  for (const Eigen::Vector3f& p : points) values.push_back(p[axis]);
  return {quantile(values, kLeftOut), quantile(values, 1.0 - kLeftOut)};
}

/// Where points fall in the picture.
struct Raster {
  explicit Raster(const std::vector<Eigen::Vector3f>& points) {
    const auto [west, east] = middleOf(points, 0);
    const auto [south, north] = middleOf(points, 1);
    area.extend(Eigen::Vector2d(west - kMargin, south - kMargin));
    area.extend(Eigen::Vector2d(east + kMargin, north + kMargin));
    pixel = std::max(kFinest, area.sizes().maxCoeff() / kLongestSide);
    width = static_cast<std::size_t>(area.sizes().x() / pixel) + 1;
    height = static_cast<std::size_t>(area.sizes().y() / pixel) + 1;
  }
  /// Nothing outside the picture.
  std::optional<std::pair<std::size_t, std::size_t>> place(const Eigen::Vector3f& p) const {
    const Eigen::Vector2d at = p.head<2>().cast<double>();
    if (!area.contains(at)) return std::nullopt;
    return std::pair{static_cast<std::size_t>((at.x() - area.min().x()) / pixel),
                     static_cast<std::size_t>((area.max().y() - at.y()) / pixel)};
  }

  Eigen::AlignedBox2d area;
  double pixel = kFinest;
  std::size_t width = 0;
  std::size_t height = 0;
};

void paint(RgbImage& image, std::size_t column, std::size_t row, const VerdictColour& colour) {
  if (column >= image.width || row >= image.height) return;
  std::uint8_t* pixel = &image.rgb[3 * (row * image.width + column)];
  pixel[0] = colour.red;
  pixel[1] = colour.green;
  pixel[2] = colour.blue;
}

void paintDensity(RgbImage& image, const Raster& raster, const DraftScores& scores) {
  std::vector<std::uint32_t> count(raster.width * raster.height, 0);
  for (std::size_t i = 0; i < scores.points.size(); ++i) {
    if (scores.verdicts[i] != MapVerdict::kTruePositive) continue;
    const auto place = raster.place(scores.points[i]);
    if (place) ++count[place->second * raster.width + place->first];
  }
  const VerdictColour full = colourOf(MapVerdict::kTruePositive);
  for (std::size_t k = 0; k < count.size(); ++k) {
    if (count[k] == 0) continue;
    const double share = std::log1p(static_cast<double>(count[k])) / std::log1p(kBrightest);
    const double light = 0.35 + 0.65 * std::min(1.0, share);
    const auto shade = [light](std::uint8_t channel) {
      return static_cast<std::uint8_t>(light * channel);
    };
    paint(image, k % raster.width, k / raster.width,
          {shade(full.red), shade(full.green), shade(full.blue)});
  }
}

void paintMistakes(RgbImage& image,
                   const Raster& raster,
                   const DraftScores& scores,
                   MapVerdict verdict) {
  for (std::size_t i = 0; i < scores.points.size(); ++i) {
    if (scores.verdicts[i] != verdict) continue;
    const auto place = raster.place(scores.points[i]);
    if (!place) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      paint(image, place->first + k % 2, place->second + k / 2, colourOf(verdict));
    }
  }
}

}  // namespace

VerdictColour colourOf(MapVerdict verdict) {
  switch (verdict) {
    case MapVerdict::kFalsePositive:
      return {240, 64, 64};
    case MapVerdict::kFalseNegative:
      return {80, 150, 255};
    case MapVerdict::kTruePositive:
      break;
  }
  return {80, 210, 120};
}

RgbImage drawVerdicts(const DraftScores& scores) {
  const Raster raster(scores.points);
  RgbImage image{raster.width, raster.height, {}};
  image.rgb.resize(3 * raster.width * raster.height);
  for (std::size_t k = 0; k < raster.width * raster.height; ++k) {
    paint(image, k % raster.width, k / raster.width, kGround);
  }
  paintDensity(image, raster, scores);
  paintMistakes(image, raster, scores, MapVerdict::kFalseNegative);
  paintMistakes(image, raster, scores, MapVerdict::kFalsePositive);
  return image;
}

}  // namespace segdf

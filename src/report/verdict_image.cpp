// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/verdict_image.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace segdf {

namespace {

constexpr double kFinest = 0.05;         // metres a pixel
constexpr double kLongestSide = 2400.0;  // pixels
constexpr double kMargin = 1.0;          // metres
constexpr double kBrightest = 40.0;      // points in a pixel
constexpr VerdictColour kGround{16, 18, 22};

/// Where points fall in the picture.
struct Raster {
  explicit Raster(const std::vector<Eigen::Vector3f>& points) {
    for (const Eigen::Vector3f& p : points) area.extend(p.head<2>().cast<double>().eval());
    if (area.isEmpty()) area.extend(Eigen::Vector2d::Zero());
    area.extend((area.min().array() - kMargin).matrix().eval());
    area.extend((area.max().array() + kMargin).matrix().eval());
    pixel = std::max(kFinest, area.sizes().maxCoeff() / kLongestSide);
    width = static_cast<std::size_t>(area.sizes().x() / pixel) + 1;
    height = static_cast<std::size_t>(area.sizes().y() / pixel) + 1;
  }
  std::size_t columnOf(const Eigen::Vector3f& p) const {
    return static_cast<std::size_t>((static_cast<double>(p.x()) - area.min().x()) / pixel);
  }
  std::size_t rowOf(const Eigen::Vector3f& p) const {
    return static_cast<std::size_t>((area.max().y() - static_cast<double>(p.y())) / pixel);
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
    ++count[raster.rowOf(scores.points[i]) * raster.width + raster.columnOf(scores.points[i])];
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
    const std::size_t column = raster.columnOf(scores.points[i]);
    const std::size_t row = raster.rowOf(scores.points[i]);
    for (std::size_t k = 0; k < 4; ++k) {
      paint(image, column + k % 2, row + k / 2, colourOf(verdict));
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

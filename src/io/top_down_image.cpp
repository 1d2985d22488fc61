// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/top_down_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/png_file.hpp"

namespace segdf {

namespace {

constexpr double kMargin = 50.0;          // metres around the way
constexpr double kFinest = 0.05;          // metres a pixel
constexpr double kLongestSide = 4000.0;   // pixels
constexpr double kScaleBar = 10.0;        // metres
constexpr std::size_t kBarThickness = 6;  // pixels
constexpr double kRangeOfHeights = 6.0;   // metres from darkest to brightest

using Colour = std::array<std::uint8_t, 3>;

// A cell of the picture as one number, the greater on top: its kind, its height, its shade.
constexpr unsigned kKindShift = 29;
constexpr unsigned kLevelShift = 8;
constexpr std::uint32_t kShadeMask = (1U << kLevelShift) - 1;
constexpr double kHighestLevel = (1U << (kKindShift - kLevelShift)) - 1;
constexpr double kLowest = 1000.0;  // metres below the map's origin

// Later kinds cover earlier ones.
enum Kind : std::uint8_t { kNothing, kGround, kOther, kVegetation, kBuilding, kMovable, kRemoved };
constexpr std::array<Colour, 7> kColours{{{16, 18, 22},
                                          {190, 190, 190},
                                          {170, 165, 200},
                                          {95, 175, 95},
                                          {225, 195, 140},
                                          {80, 170, 255},
                                          {255, 40, 40}}};
constexpr Colour kTrajectory{255, 220, 60};
constexpr Colour kWhite{255, 255, 255};

Kind kindOf(const MapPoint& point) {
  switch (point.label) {
    case semantic_kitti::kDynamic:
      return kRemoved;
    case semantic_kitti::kRoad:
      return kGround;
    case semantic_kitti::kVegetation:
      return kVegetation;
    case semantic_kitti::kBuilding:
      return kBuilding;
    case semantic_kitti::kCar:
      return kMovable;
    default:
      return kOther;
  }
}

/// Intensities come as 0..1 or 0..255.
double unitIntensity(float intensity) {
  const auto value = static_cast<double>(intensity);
  return std::clamp(value > 1.0 ? value / 255.0 : value, 0.0, 1.0);
}

std::uint32_t shadeOfGround(const MapPoint& point) {
  return static_cast<std::uint32_t>(80.0 * std::sqrt(unitIntensity(point.intensity)));
}

/// Relative to the sensor, whose height is that of the map's origin at the start.
std::uint32_t shadeOfHeight(const MapPoint& point) {
  const double share = (static_cast<double>(point.z) + 2.0) / kRangeOfHeights;
  return static_cast<std::uint32_t>(95.0 + 160.0 * std::clamp(share, 0.0, 1.0));
}

/// Height in millimetres, between the bounds of its bits.
std::uint32_t levelOf(const MapPoint& point) {
  const double level = (static_cast<double>(point.z) + kLowest) * 1000.0;
  return static_cast<std::uint32_t>(std::clamp(level, 0.0, kHighestLevel));
}

// The palette: of each kind so many shades, then the trajectory and white.
constexpr unsigned kShadeStep = 3;  // bits
constexpr std::size_t kShades = (kShadeMask + 1) >> kShadeStep;
constexpr auto kTrajectoryEntry = static_cast<std::uint8_t>(kColours.size() * kShades);
constexpr std::uint8_t kWhiteEntry = kTrajectoryEntry + 1;

Colour shaded(std::size_t kind, std::size_t shade) {
  Colour colour = kColours[kind];
  if (kind == kNothing || kind == kRemoved) return colour;
  for (std::uint8_t& channel : colour) {
    channel = static_cast<std::uint8_t>(channel * (64 + shade * 3 / 4) / 255);
  }
  return colour;
}

std::vector<Colour> palette() {
  std::vector<Colour> colours;
  for (std::size_t kind = 0; kind < kColours.size(); ++kind) {
    for (std::size_t k = 0; k < kShades; ++k) {
      colours.push_back(shaded(kind, (2 * k + 1) << (kShadeStep - 1)));  // the middle of its shades
    }
  }
  colours.push_back(kTrajectory);
  colours.push_back(kWhite);
  return colours;
}

std::uint8_t entryOf(std::uint32_t cell) {
  return static_cast<std::uint8_t>((cell >> kKindShift) * kShades +
                                   ((cell & kShadeMask) >> kShadeStep));
}

Eigen::AlignedBox2d areaAround(const std::vector<Eigen::Vector2d>& trajectory) {
  Eigen::AlignedBox2d area;
  for (const Eigen::Vector2d& place : trajectory) area.extend(place);
  if (area.isEmpty()) area.extend(Eigen::Vector2d::Zero());
  area.extend(Eigen::Vector2d(area.min().array() - kMargin));
  area.extend(Eigen::Vector2d(area.max().array() + kMargin));
  return area;
}

}  // namespace

TopDownImage::TopDownImage(std::vector<Eigen::Vector2d> trajectory)
    : trajectory_(std::move(trajectory)),
      area_(areaAround(trajectory_)),
      metres_per_pixel_(std::max(kFinest, area_.sizes().maxCoeff() / kLongestSide)),
      width_(static_cast<std::size_t>(area_.sizes().x() / metres_per_pixel_) + 1),
      height_(static_cast<std::size_t>(area_.sizes().y() / metres_per_pixel_) + 1),
      cells_(width_ * height_) {}

std::size_t TopDownImage::pixelAt(double x, double y) const {
  const Eigen::Vector2d place(x, y);
  if (!area_.contains(place)) return cells_.size();
  const auto column = static_cast<std::size_t>((x - area_.min().x()) / metres_per_pixel_);
  const auto row = static_cast<std::size_t>((area_.max().y() - y) / metres_per_pixel_);
  return std::min(row, height_ - 1) * width_ + std::min(column, width_ - 1);
}

void TopDownImage::add(const MapPoint& point) {
  const std::size_t pixel = pixelAt(static_cast<double>(point.x), static_cast<double>(point.y));
  if (pixel == cells_.size()) return;
  const Kind kind = kindOf(point);
  const std::uint32_t shade = kind == kGround ? shadeOfGround(point) : shadeOfHeight(point);
  const std::uint32_t cell =
      (static_cast<std::uint32_t>(kind) << kKindShift) | (levelOf(point) << kLevelShift) | shade;
  // The picture is larger than any cache: memory brings the pixel while the next points are seen.
  __builtin_prefetch(&cells_[pixel], 1);
  waiting_[waiting_count_++] = {pixel, cell};
  if (waiting_count_ == waiting_.size()) drawWaiting();
}

void TopDownImage::drawWaiting() {
  for (std::size_t k = 0; k < waiting_count_; ++k) {
    std::uint32_t& cell = cells_[waiting_[k].pixel];
    cell = std::max(cell, waiting_[k].cell);
  }
  waiting_count_ = 0;
}

void TopDownImage::drawTrajectory(std::vector<std::uint8_t>& pixels) const {
  for (std::size_t k = 1; k < trajectory_.size(); ++k) {
    const Eigen::Vector2d way = trajectory_[k] - trajectory_[k - 1];
    const auto steps = static_cast<std::size_t>(way.norm() / metres_per_pixel_) + 1;
    for (std::size_t s = 0; s <= steps; ++s) {
      const Eigen::Vector2d at =
          trajectory_[k - 1] + way * (static_cast<double>(s) / static_cast<double>(steps));
      const std::size_t pixel = pixelAt(at.x(), at.y());
      if (pixel < cells_.size()) pixels[pixel] = kTrajectoryEntry;
    }
  }
}

void TopDownImage::drawScale(std::vector<std::uint8_t>& pixels) const {
  const auto length = static_cast<std::size_t>(kScaleBar / metres_per_pixel_);
  const std::size_t margin = 4 * kBarThickness;
  if (width_ < length + margin || height_ < margin + kBarThickness) return;
  for (std::size_t row = height_ - margin; row < height_ - margin + kBarThickness; ++row) {
    for (std::size_t column = margin; column < margin + length; ++column) {
      pixels[row * width_ + column] = kWhiteEntry;
    }
  }
}

void TopDownImage::write(const std::filesystem::path& file) {
  drawWaiting();
  std::vector<std::uint8_t> pixels(cells_.size());
  std::transform(cells_.begin(), cells_.end(), pixels.begin(), entryOf);
  drawTrajectory(pixels);
  drawScale(pixels);
  writePng(file, PaletteImage{width_, height_, palette(), std::move(pixels)});
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/visibility_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "segdf/segmentation/arc_tangent.hpp"

namespace segdf {

namespace {

constexpr float kPi = 3.14159265358979F;
constexpr float kRadians = kPi / 180.0F;
// Nearer, the margin spans half the image; farther, beams are too far apart to say much.
constexpr float kNearestPlace = 1.4F;
constexpr float kFarthestPlace = 75.0F;
constexpr std::int16_t kEmpty = std::numeric_limits<std::int16_t>::max();
constexpr float kFarthestRange = 320.0F;  // metres; fits in 16 bits as centimetres
constexpr int kEnoughBins = 3;            // that are not empty, for FREE beside an empty own bin

float horizontal(const Eigen::Vector3f& x) { return std::sqrt(x.x() * x.x() + x.y() * x.y()); }

/// Angle of (x, y), rad, in [-pi, pi].
float angleOf(float y, float x) {
  return static_cast<float>(arcTangent2(static_cast<double>(y), static_cast<double>(x)));
}

int centimetres(float metres) {
  return static_cast<int>(std::lround(100.0F * std::min(metres, kFarthestRange)));
}

}  // namespace

VisibilityImage::VisibilityImage(const std::vector<Point>& points,
                                 const std::vector<PointRole>& roles,
                                 const DynamicConfig& config)
    : tau_(static_cast<float>(config.tau)),
      tau_ratio_(static_cast<float>(config.tau_ratio)),
      margin_(static_cast<float>(config.margin)),
      row_step_(static_cast<float>(config.dtheta_v) * kRadians) {
  columns_ = static_cast<int>(std::lround(360.0 / config.dphi_v));
  column_step_ = 2.0F * kPi / static_cast<float>(columns_);
  pad_ = std::min(windowAt(kNearestPlace).columns, columns_ - 1);
  stride_ = columns_ + 2 * pad_;
  fill(points, roles);
  prepareMinima();
}

VisibilityImage::Window VisibilityImage::windowAt(float range) const {
  Window window;
  window.columns = std::max(1, static_cast<int>(std::ceil(margin_ / range / column_step_)));
  window.rows =
      static_cast<int>(std::ceil(static_cast<float>(window.columns) * column_step_ / row_step_));
  return window;
}

void VisibilityImage::fill(const std::vector<Point>& points, const std::vector<PointRole>& roles) {
  std::vector<float> elevations(points.size());
  float highest = -kPi;
  lowest_ = kPi;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    elevations[i] = angleOf(points[i].z, horizontal(points[i].position()));
    lowest_ = std::min(lowest_, elevations[i]);
    highest = std::max(highest, elevations[i]);
  }
  if (highest < lowest_) return;
  rows_ = static_cast<int>((highest - lowest_) / row_step_) + 1;
  nearest_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(stride_), kEmpty);
  farthest_.assign(nearest_.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const Point& p = points[i];
    const int row = static_cast<int>((elevations[i] - lowest_) / row_step_);
    const int column =
        std::min(static_cast<int>((angleOf(p.y, p.x) + kPi) / column_step_), columns_ - 1);
    const auto range = static_cast<Centimetres>(centimetres(p.position().norm()));
    const std::size_t bin = index(std::min(row, rows_ - 1), column);
    nearest_[bin] = std::min(nearest_[bin], range);
    farthest_[bin] = std::max(farthest_[bin], range);
  }
  for (int row = 0; row < rows_; ++row) {
    for (int k = 1; k <= pad_; ++k) {
      for (auto* image : {&nearest_, &farthest_}) {
        (*image)[index(row, -k)] = (*image)[index(row, columns_ - k)];
        (*image)[index(row, columns_ - 1 + k)] = (*image)[index(row, k - 1)];
      }
    }
  }
}

void VisibilityImage::prepareMinima() {
  for (int level = 0; level < kLevels; ++level) {
    Window window;
    window.columns = level + 1;
    window.rows =
        static_cast<int>(std::ceil(static_cast<float>(window.columns) * column_step_ / row_step_));
    minima_[static_cast<std::size_t>(level)] = minima(window);
  }
}

/// Minimum over the window around each bin: first along the rows, then across them.
std::vector<VisibilityImage::Centimetres> VisibilityImage::minima(const Window& window) const {
  std::vector<Centimetres> along(nearest_.size(), kEmpty);
  const auto stride = static_cast<std::size_t>(stride_);
  const auto reach = static_cast<std::size_t>(std::min(window.columns, pad_));
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
    const Centimetres* in = nearest_.data() + row * stride;
    Centimetres* out = along.data() + row * stride;
    for (std::size_t shift = 0; shift <= 2 * reach; ++shift) {
      for (std::size_t c = reach; c + reach < stride; ++c) {
        out[c] = std::min(out[c], in[c + shift - reach]);
      }
    }
  }
  std::vector<Centimetres> result = along;
  for (int row = 0; row < rows_; ++row) {
    Centimetres* out = result.data() + static_cast<std::size_t>(row) * stride;
    for (int r = std::max(0, row - window.rows); r <= std::min(rows_ - 1, row + window.rows); ++r) {
      const Centimetres* in = along.data() + static_cast<std::size_t>(r) * stride;
      for (std::size_t c = 0; c < stride; ++c) out[c] = std::min(out[c], in[c]);
    }
  }
  return result;
}

VolumetricState VisibilityImage::stateOf(const Eigen::Vector3f& place) const {
  const float range = place.norm();
  if (!(range >= kNearestPlace && range <= kFarthestPlace) || rows_ == 0) {
    return VolumetricState::kUnknown;
  }
  const float from_lowest = (angleOf(place.z(), horizontal(place)) - lowest_) / row_step_;
  const int row = static_cast<int>(std::floor(from_lowest));
  if (row < 0 || row >= rows_) return VolumetricState::kUnknown;
  const int column = std::min(
      static_cast<int>((angleOf(place.y(), place.x()) + kPi) / column_step_), columns_ - 1);
  const float tolerance = std::max(tau_, tau_ratio_ * range);
  const int near = centimetres(range - tolerance);
  const int far = centimetres(range + tolerance);

  const std::size_t bin = index(row, column);
  const auto within = [near, far](Centimetres value) { return value >= near && value <= far; };
  if (within(nearest_[bin]) || within(farthest_[bin])) return VolumetricState::kHit;
  const Window window = windowAt(range);
  if (window.columns <= kLevels) {
    // Nearly all answers are found here: nothing around begins before the place, or nothing is
    // around.
    const Centimetres least = minima_[static_cast<std::size_t>(window.columns - 1)][bin];
    if (least == kEmpty) return VolumetricState::kUnknown;
    if (least > far && nearest_[bin] != kEmpty) return VolumetricState::kFree;
  }
  return search(row, column, window, near, far);
}

VolumetricState VisibilityImage::search(
    int row, int column, const Window& window, int near, int far) const {
  int seen = 0;
  int behind = 0;
  int before = 0;
  for (int r = std::max(0, row - window.rows); r <= std::min(rows_ - 1, row + window.rows); ++r) {
    for (int c = column - window.columns; c <= column + window.columns; ++c) {
      const std::size_t bin = index(r, c);
      const int nearest = nearest_[bin];
      const int farthest = farthest_[bin];
      if (nearest == kEmpty) continue;
      if ((nearest >= near && nearest <= far) || (farthest >= near && farthest <= far)) {
        return VolumetricState::kHit;
      }
      ++seen;
      behind += nearest > far ? 1 : 0;
      before += nearest < near ? 1 : 0;
    }
  }
  const bool own = nearest_[index(row, column)] != kEmpty;
  if (seen > 0 && behind == seen && (own || seen >= kEnoughBins)) return VolumetricState::kFree;
  if (seen > 0 && 2 * before >= seen) return VolumetricState::kOccluded;
  return VolumetricState::kUnknown;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/visibility_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
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
constexpr float kRowLevels = 256.0F;      // of a row, told apart
constexpr std::uint8_t kTopLevel = 255;
constexpr int kEnoughBins = 3;  // that are not empty, for FREE beside an empty own bin

// Bins that are looked at together, as many as fit the registers of every processor; each fills two
// lanes.
constexpr std::size_t kBins = 4;
using Lanes [[gnu::vector_size(4 * kBins)]] = std::int16_t;
constexpr Lanes kBinNumbers{0, 0, 1, 1, 2, 2, 3, 3};
constexpr Lanes kNearestLanes{-1, 0, -1, 0, -1, 0, -1, 0};

Lanes load(const std::int16_t* lane) {
  Lanes lanes;
  std::memcpy(&lanes, lane, sizeof(lanes));
  return lanes;
}

/// Of four bins, each.
Lanes repeated(std::int16_t even, std::int16_t odd) {
  const Lanes lanes{even, odd, even, odd, even, odd, even, odd};
  return lanes;
}

bool isAnySet(const Lanes& lanes) {
  std::array<std::uint64_t, sizeof(Lanes) / sizeof(std::uint64_t)> words{};
  std::memcpy(words.data(), &lanes, sizeof(lanes));
  return std::any_of(words.begin(), words.end(), [](std::uint64_t word) { return word != 0; });
}

int sumOf(const Lanes& lanes) {
  int sum = 0;
  for (std::size_t k = 0; k < 2 * kBins; ++k) sum += lanes[k];
  return sum;
}

/// How high in a row a place lies, from its lower edge to the top. @param place in rows, in this
/// one or above it
std::uint8_t levelOf(float place, int row) {
  const float level = kRowLevels * (place - static_cast<float>(row));
  return static_cast<std::uint8_t>(std::min(level, static_cast<float>(kTopLevel)));
}

int centimetres(float metres) {
  return static_cast<int>(std::lround(100.0F * std::min(metres, kFarthestRange)));
}

/// Where points are seen from the sensor.
struct Directions {
  std::vector<float> elevation;  ///< rad
  std::vector<float> azimuth;    ///< rad
  std::vector<float> range;      ///< metres
};

Directions directionsOf(const std::vector<Point>& points) {
  const std::size_t count = points.size();
  // Coordinates one after the other are what compilers make several at a time of.
  Eigen::MatrixX3f places(static_cast<Eigen::Index>(count), 3);
  for (std::size_t i = 0; i < count; ++i) {
    places.row(static_cast<Eigen::Index>(i)) = points[i].position();
  }
  const float* x = places.col(0).data();
  const float* y = places.col(1).data();
  const float* z = places.col(2).data();
  Directions seen{std::vector<float>(count), std::vector<float>(count), std::vector<float>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const float squared = x[i] * x[i] + y[i] * y[i];
    seen.elevation[i] = arcTangent2(z[i], std::sqrt(squared));
    seen.azimuth[i] = arcTangent2(y[i], x[i]);
    seen.range[i] = std::sqrt(squared + z[i] * z[i]);
  }
  return seen;
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
  pad_ =
      std::min(static_cast<int>(std::ceil(margin_ / kNearestPlace / column_step_)), columns_ - 1);
  stride_ = columns_ + 2 * pad_;
  fill(points, roles);
  prepareLevels();
}

bool VisibilityImage::isSeen(std::size_t bin) const { return nearestOf(bounds_, bin) != kEmpty; }

VisibilityImage::Window VisibilityImage::windowOf(int columns) const {
  const float across = static_cast<float>(columns) * column_step_;
  return {static_cast<int>(std::ceil(across / row_step_)), columns};
}

void VisibilityImage::fill(const std::vector<Point>& points, const std::vector<PointRole>& roles) {
  const Directions seen = directionsOf(points);
  float highest = -kPi;
  lowest_ = kPi;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    lowest_ = std::min(lowest_, seen.elevation[i]);
    highest = std::max(highest, seen.elevation[i]);
  }
  if (highest < lowest_) return;
  rows_ = static_cast<int>((highest - lowest_) / row_step_) + 1;
  // The last bins are loaded together with what comes after them.
  const std::size_t bins = index(rows_, 0) + kBins;
  bounds_.assign(2 * bins, 0);
  for (std::size_t bin = 0; bin < bins; ++bin) bounds_[2 * bin] = kEmpty;
  lowest_level_.assign(bins, kTopLevel);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (roles[i] == PointRole::kUnused) continue;
    const float place = (seen.elevation[i] - lowest_) / row_step_;
    const int row = static_cast<int>(place);
    const int column = static_cast<int>((seen.azimuth[i] + kPi) / column_step_);
    const auto range = static_cast<Centimetres>(centimetres(seen.range[i]));
    const std::size_t bin = index(std::min(row, rows_ - 1), std::min(column, columns_ - 1));
    Centimetres* bounds = bounds_.data() + 2 * bin;
    bounds[0] = std::min(bounds[0], range);
    bounds[1] = std::min(bounds[1], static_cast<Centimetres>(-range));
    lowest_level_[bin] = std::min(lowest_level_[bin], levelOf(place, row));
  }
  wrap();
}

void VisibilityImage::wrap() {
  const auto copy = [this](std::size_t from, std::size_t to) {
    std::copy_n(bounds_.begin() + static_cast<std::ptrdiff_t>(2 * from), 2,
                bounds_.begin() + static_cast<std::ptrdiff_t>(2 * to));
    lowest_level_[to] = lowest_level_[from];
  };
  for (int row = 0; row < rows_; ++row) {
    for (int k = 1; k <= pad_; ++k) {
      copy(index(row, columns_ - k), index(row, -k));
      copy(index(row, k - 1), index(row, columns_ - 1 + k));
    }
  }
}

void VisibilityImage::prepareLevels() {
  int columns = 0;
  for (Level& level : levels_) {
    level.window = windowOf(++columns);
    level.bounds = boundsAround(level.window);
  }
}

/// First along the rows, then across them.
VisibilityImage::Bounds VisibilityImage::boundsAround(const Window& window) const {
  Bounds along = bounds_;
  const auto length = 2 * static_cast<std::size_t>(stride_);
  const auto reach = 2 * static_cast<std::size_t>(std::min(window.columns, pad_));
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
    const Centimetres* in = bounds_.data() + row * length;
    Centimetres* out = along.data() + row * length;
    for (std::size_t shift = 0; shift <= 2 * reach; shift += 2) {
      for (std::size_t c = reach; c + reach < length; ++c) {
        out[c] = std::min(out[c], in[c + shift - reach]);
      }
    }
  }
  Bounds result = along;
  for (int row = 0; row < rows_; ++row) {
    Centimetres* out = result.data() + static_cast<std::size_t>(row) * length;
    for (int r = std::max(0, row - window.rows); r <= std::min(rows_ - 1, row + window.rows); ++r) {
      const Centimetres* in = along.data() + static_cast<std::size_t>(r) * length;
      for (std::size_t c = 0; c < length; ++c) out[c] = std::min(out[c], in[c]);
    }
  }
  return result;
}

void VisibilityImage::look(const Eigen::Ref<const Eigen::MatrixX3f>& places,
                           const Eigen::Isometry3f& image_T_places,
                           VolumetricState* states) const {
  for (Eigen::Index first = 0; first < places.rows(); first += kBlock) {
    const Eigen::Index count = std::min<Eigen::Index>(kBlock, places.rows() - first);
    const Block block = project(places.middleRows(first, count), image_T_places);
    for (Eigen::Index k = 0; k < count; ++k) fetch(block, static_cast<std::size_t>(k));
    for (Eigen::Index k = 0; k < count; ++k) {
      states[first + k] = stateOf(block, static_cast<std::size_t>(k));
    }
  }
}

VisibilityImage::Block VisibilityImage::project(const Eigen::Ref<const Eigen::MatrixX3f>& places,
                                                const Eigen::Isometry3f& image_T_places) const {
  const Eigen::Matrix3f r = image_T_places.linear();
  const Eigen::Vector3f t = image_T_places.translation();
  const float* px = places.col(0).data();
  const float* py = places.col(1).data();
  const float* pz = places.col(2).data();
  Block block;
  const auto count = static_cast<std::size_t>(places.rows());
  for (std::size_t k = 0; k < count; ++k) {
    const float x = r(0, 0) * px[k] + r(0, 1) * py[k] + r(0, 2) * pz[k] + t.x();
    const float y = r(1, 0) * px[k] + r(1, 1) * py[k] + r(1, 2) * pz[k] + t.y();
    const float z = r(2, 0) * px[k] + r(2, 1) * py[k] + r(2, 2) * pz[k] + t.z();
    const float squared = x * x + y * y;
    const float range = std::sqrt(squared + z * z);
    block.range[k] = range;
    block.row[k] = (arcTangent2(z, std::sqrt(squared)) - lowest_) / row_step_;
    block.column[k] = (arcTangent2(y, x) + kPi) / column_step_;
    block.margin[k] = margin_ / range / column_step_;
  }
  return block;
}

bool VisibilityImage::isInside(const Block& block, std::size_t k) const {
  return block.range[k] >= kNearestPlace && block.range[k] <= kFarthestPlace &&
         block.row[k] >= 0.0F && block.row[k] < static_cast<float>(rows_);
}

VisibilityImage::Bin VisibilityImage::binOf(const Block& block, std::size_t k) const {
  const int row = static_cast<int>(block.row[k]);
  const float margin = block.margin[k] * column_step_ / row_step_;  // rows
  return {row, std::min(static_cast<int>(block.column[k]), columns_ - 1),
          levelOf(block.row[k] + margin, row)};
}

void VisibilityImage::fetch(const Block& block, std::size_t k) const {
  if (!isInside(block, k)) return;
  const Bin bin = binOf(block, k);
  const std::size_t own = index(bin.row, bin.column);
  __builtin_prefetch(bounds_.data() + 2 * own);
  const int columns = columnsOf(block, k);
  if (columns > kLevels) return;
  __builtin_prefetch(levels_[static_cast<std::size_t>(columns - 1)].bounds.data() + 2 * own);
}

VolumetricState VisibilityImage::stateOf(const Block& block, std::size_t k) const {
  if (!isInside(block, k)) return VolumetricState::kUnknown;
  const Bin bin = binOf(block, k);
  const float range = block.range[k];
  const float tolerance = std::max(tau_, tau_ratio_ * range);
  const int near = centimetres(range - tolerance);
  const int far = centimetres(range + tolerance);

  const std::size_t own = index(bin.row, bin.column);
  const auto within = [near, far](int value) { return value >= near && value <= far; };
  if (within(nearestOf(bounds_, own)) || within(farthestOf(bounds_, own))) {
    return VolumetricState::kHit;
  }
  const int columns = columnsOf(block, k);
  if (columns > kLevels) return search(bin, windowOf(columns), near, far);
  // Most answers are found here: nothing is around, or all of it begins behind the place, or all of
  // it ends before.
  const Level& level = levels_[static_cast<std::size_t>(columns - 1)];
  const int nearest = nearestOf(level.bounds, own);
  if (nearest == kEmpty) return VolumetricState::kUnknown;
  if (nearest > far && isSeen(own)) return stateOfPassed(bin, level.window);
  if (farthestOf(level.bounds, own) < near) return VolumetricState::kOccluded;
  return search(bin, level.window, near, far);
}

VolumetricState VisibilityImage::stateOfPassed(const Bin& bin, const Window& window) const {
  const bool told = bin.row == 0 || returnsBelow(bin, window);
  return told ? VolumetricState::kFree : VolumetricState::kUnknown;
}

bool VisibilityImage::returnsBelow(const Bin& bin, const Window& window) const {
  for (int right = -window.columns; right <= window.columns; ++right) {
    const std::size_t beside = index(bin.row, bin.column + right);
    if (isSeen(beside) && lowest_level_[beside] <= bin.level) return true;
  }
  for (int row = bin.row - 1; row >= std::max(0, bin.row - window.rows); --row) {
    for (int right = -window.columns; right <= window.columns; ++right) {
      if (isSeen(index(row, bin.column + right))) return true;
    }
  }
  return false;
}

VolumetricState VisibilityImage::search(const Bin& bin,
                                        const Window& window,
                                        int near,
                                        int far) const {
  const std::size_t width = 2 * static_cast<std::size_t>(window.columns) + 1;
  const auto first = static_cast<std::int16_t>(near);
  const auto last = static_cast<std::int16_t>(far);
  const auto minus = [](std::int16_t value) { return static_cast<std::int16_t>(-value); };
  const Lanes least = repeated(first, minus(last));
  const Lanes most = repeated(last, minus(first));
  Lanes seen{};
  Lanes behind{};
  Lanes before{};
  const auto hits = [&](int row) {
    const std::size_t corner = index(row, bin.column - window.columns);
    Lanes hit{};
    for (std::size_t k = 0; k < width; k += kBins) {
      const Lanes bounds = load(bounds_.data() + 2 * (corner + k));
      const Lanes inside = kBinNumbers < static_cast<std::int16_t>(width - k);
      const Lanes filled = inside & kNearestLanes & (bounds != kEmpty);
      // An empty bin has neither bound there.
      hit |= inside & (bounds >= least) & (bounds <= most);
      // A comparison that holds is -1.
      seen -= filled;
      behind -= filled & (bounds > last);
      before -= filled & (bounds < first);
    }
    return isAnySet(hit);
  };
  // From the middle outwards: what is found again is mostly found close by.
  if (hits(bin.row)) return VolumetricState::kHit;
  for (int away = 1; away <= window.rows; ++away) {
    if (bin.row - away >= 0 && hits(bin.row - away)) return VolumetricState::kHit;
    if (bin.row + away < rows_ && hits(bin.row + away)) return VolumetricState::kHit;
  }
  const int bins = sumOf(seen);
  const bool own = isSeen(index(bin.row, bin.column));
  if (bins > 0 && sumOf(behind) == bins && (own || bins >= kEnoughBins)) {
    return stateOfPassed(bin, window);
  }
  if (bins > 0 && 2 * sumOf(before) >= bins) return VolumetricState::kOccluded;
  return VolumetricState::kUnknown;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/view_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <Eigen/Geometry>

namespace segdf {

namespace {

constexpr double kWider = 1.2;           // from one grid to the next
constexpr double kHalfRange = 32766.0;   // steps of an int16
constexpr std::int64_t kHalf = 1 << 19;  // voxels on either side of the origin
constexpr std::size_t kMostClasses = 256;

std::uint64_t keyOf(const ViewPoint& point, double voxel) {
  std::uint64_t key = static_cast<std::uint64_t>(point.fate);
  for (int k = 0; k < 3; ++k) {
    const auto cell =
        static_cast<std::int64_t>(std::floor(static_cast<double>(point.position[k]) / voxel));
    key = key << 20U | (static_cast<std::uint64_t>(cell + kHalf) & 0xFFFFFU);
  }
  return key;
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::vector<std::uint16_t> classesOf(const std::vector<ViewPoint>& points) {
  std::vector<std::uint16_t> classes;
  for (const ViewPoint& point : points) {
    const auto at = std::lower_bound(classes.begin(), classes.end(), point.semantic_class);
    const bool known = at != classes.end() && *at == point.semantic_class;
    if (!known && classes.size() < kMostClasses) classes.insert(at, point.semantic_class);
  }
  return classes;
}

std::uint8_t indexIn(const std::vector<std::uint16_t>& classes, std::uint16_t semantic_class) {
  const auto at = std::lower_bound(classes.begin(), classes.end(), semantic_class);
  const auto last = static_cast<std::ptrdiff_t>(classes.size()) - 1;
  return static_cast<std::uint8_t>(std::min(at - classes.begin(), last));
}

}  // namespace

void ViewCloud::add(const ViewPoint& point) {
  points_.push_back(point);
  if (points_.size() >= 3 * most_points_) thinTo(3 * most_points_ / 2);
}

void ViewCloud::thin() {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i) order[i] = {keyOf(points_[i], voxel_), i};
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end(),
                          [](const auto& a, const auto& b) { return a.first == b.first; }),
              order.end());
  std::vector<ViewPoint> kept;
  kept.reserve(order.size());
  for (const auto& [key, i] : order) kept.push_back(points_[i]);
  points_ = std::move(kept);
}

void ViewCloud::thinTo(std::size_t limit) {
  for (thin(); points_.size() > limit; thin()) voxel_ *= kWider;
}

PackedCloud ViewCloud::finish() {
  thinTo(most_points_);
  PackedCloud packed;
  packed.count = points_.size();
  packed.voxel = voxel_;
  packed.classes = classesOf(points_);
  Eigen::AlignedBox3d box;
  for (const ViewPoint& point : points_) box.extend(point.position.cast<double>().eval());
  if (!box.isEmpty()) {
    packed.origin = box.center();
    packed.step = std::max(1e-3, 0.5 * box.sizes().maxCoeff() / kHalfRange);
  }
  packed.bytes.reserve(11 * points_.size());
  for (const ViewPoint& point : points_) {
    const Eigen::Vector3d steps = (point.position.cast<double>() - packed.origin) / packed.step;
    for (int k = 0; k < 3; ++k)
      append(packed.bytes, static_cast<std::int16_t>(std::lround(steps[k])));
  }
  for (const ViewPoint& point : points_) append(packed.bytes, point.instance);
  for (const ViewPoint& point : points_) append(packed.bytes, point.intensity);
  for (const ViewPoint& point : points_) {
    append(packed.bytes, indexIn(packed.classes, point.semantic_class));
  }
  for (const ViewPoint& point : points_) append(packed.bytes, point.fate);
  return packed;
}

}  // namespace segdf

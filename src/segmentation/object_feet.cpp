// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/object_feet.hpp"

#include <cmath>
#include <cstddef>

#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

constexpr std::size_t kGrain = 4096;
// Lasers looked at above a point. With 64 of them at 5 m, 8 reach 0.3 m up.
constexpr int kClimbRows = 8;
constexpr int kTouchRows = 1;
constexpr int kTouchColumns = 3;
constexpr int kTouchPasses = 2;

/// Horizontal distance, metres; sensors do not see far enough for std::hypot's care.
float fromAxis(const Point& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

/// Sets `changed[i]` for each ground point for which `releases(i)`, then the roles.
template <class Condition>
void release(int threads, const Condition& releases, std::vector<PointRole>& roles) {
  std::vector<std::uint8_t> changed(roles.size(), 0);
  parallelBlocks(roles.size(), kGrain, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (roles[i] == PointRole::kGround && releases(i)) changed[i] = 1;
    }
  });
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (changed[i] != 0) roles[i] = PointRole::kObject;
  }
}

class Feet {
 public:
  Feet(const std::vector<Point>& points, const RangeImage& image, const GroundConfig& config)
      : points_(points),
        image_(image),
        foot_reach_(static_cast<float>(config.foot_reach)),
        foot_rise_(static_cast<float>(config.foot_rise)),
        touch_reach_(static_cast<float>(config.touch_reach)) {}

  /// Something stands on the point.
  bool stands(std::size_t i) const {
    const Point& foot = points_[i];
    const float distance = fromAxis(foot);
    for (int up = 1; up <= kClimbRows; ++up) {
      const std::int32_t j = image_.at(image_.rowOf(i) - up, image_.columnOf(i));
      if (j == RangeImage::kNone) continue;
      const Point& above = points_[static_cast<std::size_t>(j)];
      const float rise = above.z - foot.z;
      const float away = std::abs(fromAxis(above) - distance);
      if (away > foot_reach_ || rise <= away) return false;
      if (rise >= foot_rise_) return true;
    }
    return false;
  }

  /// An object point lies next to the point.
  bool touches(std::size_t i, const std::vector<PointRole>& roles) const {
    for (int row = -kTouchRows; row <= kTouchRows; ++row) {
      for (int column = -kTouchColumns; column <= kTouchColumns; ++column) {
        const std::int32_t j = image_.at(image_.rowOf(i) + row, image_.columnOf(i) + column);
        if (j == RangeImage::kNone) continue;
        const auto neighbour = static_cast<std::size_t>(j);
        if (roles[neighbour] != PointRole::kObject) continue;
        const Eigen::Vector3f way = points_[neighbour].position() - points_[i].position();
        if (way.squaredNorm() < touch_reach_ * touch_reach_) return true;
      }
    }
    return false;
  }

 private:
  const std::vector<Point>& points_;
  const RangeImage& image_;
  float foot_reach_;
  float foot_rise_;
  float touch_reach_;
};

}  // namespace

void releaseStanding(const std::vector<Point>& points,
                     const RangeImage& image,
                     const GroundConfig& config,
                     int threads,
                     std::vector<PointRole>& roles) {
  const Feet feet(points, image, config);
  release(
      threads, [&](std::size_t i) { return feet.stands(i); }, roles);
}

void releaseTouching(const std::vector<Point>& points,
                     const RangeImage& image,
                     const std::vector<float>& height,
                     const GroundConfig& config,
                     int threads,
                     std::vector<PointRole>& roles) {
  const Feet feet(points, image, config);
  const auto least = static_cast<float>(config.touch_height);
  for (int pass = 0; pass < kTouchPasses; ++pass) {
    release(
        threads, [&](std::size_t i) { return height[i] > least && feet.touches(i, roles); }, roles);
  }
}

}  // namespace segdf

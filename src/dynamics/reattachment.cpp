// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/reattachment.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "segdf/dynamics/area_index.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/footprint.hpp"
#include "segdf/dynamics/local_ground.hpp"

namespace segdf {

namespace {

constexpr std::uint8_t kFreeRatio = 2;
constexpr std::size_t kMinUpper = 3;

/// Seen from above.
Eigen::AlignedBox2f areaOf(const Segment& segment) {
  return {segment.bounds.min().head<2>(), segment.bounds.max().head<2>()};
}

/// The points that show where the object stands: those above the height at which the ground around
/// it may have been taken along; all of them for something lower.
std::vector<Eigen::Vector2f> upperPoints(const KeyFrame& frame,
                                         const Segment& segment,
                                         const LocalGround& ground,
                                         float low) {
  std::vector<Eigen::Vector2f> upper;
  std::vector<Eigen::Vector2f> all;
  for (std::uint32_t i : segment.points) {
    const Eigen::Vector2f x = frame.scan.points[i].position().head<2>();
    all.push_back(x);
    if (ground.heightOf(i) > low) upper.push_back(x);
  }
  return upper.size() >= kMinUpper ? upper : all;
}

/// A removed instance and the ground that it stands on.
class Standing {
 public:
  Standing(const KeyFrame& frame,
           const AreaIndex& places,
           const Segment& segment,
           const DynamicConfig& config)
      : frame_(frame),
        top_(static_cast<float>(config.foot_height)),
        bottom_(static_cast<float>(config.foot_bottom)),
        ground_(frame, places, areaOf(segment)),
        footprint_(upperPoints(frame, segment, ground_, top_),
                   static_cast<float>(config.foot_margin)) {}

  /// True for a point of the ground around, whatever it was taken for.
  bool isGround(std::uint32_t i) const {
    const float height = ground_.heightOf(i);
    return height < bottom_ || (height < top_ && !isUnder(i));
  }
  /// True for a point of the object that was taken for ground.
  bool isFoot(std::uint32_t i) const { return ground_.heightOf(i) >= bottom_ && isUnder(i); }
  /// What isUnder can be true for.
  const Eigen::AlignedBox2f& area() const { return footprint_.bounds(); }

 private:
  bool isUnder(std::uint32_t i) const {
    return footprint_.contains(frame_.scan.points[i].position().head<2>());
  }

  const KeyFrame& frame_;
  float top_;
  float bottom_;
  LocalGround ground_;
  Footprint footprint_;
};

void releaseGround(KeyFrame& frame, Segment& segment, const Standing& standing) {
  std::vector<std::uint32_t> object;
  for (std::uint32_t i : segment.points) {
    if (standing.isGround(i)) {
      frame.seg.roles[i] = PointRole::kGround;
    } else {
      object.push_back(i);
    }
  }
  segment.points = std::move(object);
}

/// Marks the points that are ground or in no instance.
std::vector<std::uint8_t> groundAndLoosePoints(const KeyFrame& frame) {
  std::vector<std::uint8_t> marks(frame.scan.points.size());
  for (std::size_t i = 0; i < marks.size(); ++i) {
    marks[i] = frame.seg.roles[i] != PointRole::kUnused ? 1 : 0;
  }
  for (const Segment& segment : frame.seg.segments) {
    for (std::uint32_t i : segment.points) marks[i] = 0;
  }
  return marks;
}

}  // namespace

void removeLoosePoints(KeyFrame& frame, const DynamicConfig& config) {
  const FrameEvidence& evidence = *frame.evidence;
  const std::size_t loose = evidence.begin.size() - 2;
  const auto least = static_cast<std::uint8_t>(config.loose_votes);
  for (std::uint32_t k = evidence.begin[loose]; k < evidence.begin[loose + 1]; ++k) {
    const PlaceEvidence& e = evidence.answers[k];
    const std::uint32_t i = evidence.listed[evidence.first[k]];
    // Kerbs are looked at so flatly that a small tilt of the pose makes them seem passed through.
    if (frame.seg.height[i] < static_cast<float>(config.foot_height)) continue;
    if (e.free >= least && e.free >= kFreeRatio * e.hit) frame.removed.push_back(i);
  }
}

void settleGround(KeyFrame& frame, const DynamicConfig& config) {
  const std::vector<std::uint8_t> may_be_foot = groundAndLoosePoints(frame);
  const AreaIndex places(frame.scan.points, frame.seg.roles);
  for (std::size_t s = 0; s < frame.instances.size(); ++s) {
    if (!frame.instances[s].dynamic) continue;
    const Standing standing(frame, places, frame.seg.segments[s], config);
    for (std::uint32_t i : places.pointsIn(standing.area())) {
      if (may_be_foot[i] != 0 && standing.isFoot(i)) frame.removed.push_back(i);
    }
    releaseGround(frame, frame.seg.segments[s], standing);
  }
  std::sort(frame.removed.begin(), frame.removed.end());
  frame.removed.erase(std::unique(frame.removed.begin(), frame.removed.end()), frame.removed.end());
}

}  // namespace segdf

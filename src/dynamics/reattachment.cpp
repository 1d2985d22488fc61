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
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/local_ground.hpp"

namespace segdf {

namespace {

constexpr std::uint8_t kFreeRatio = 2;
constexpr float kNear = 2.0F;      // metres: about half a car, seen from one end
constexpr float kBeside = 1.0F;    // metres
constexpr float kSwept = 0.5F;     // metres, around where it moved
constexpr double kEnclosed = 0.5;  // share of an instance inside of another
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
  for (std::uint32_t i : segment.points) {
    if (ground.heightOf(i) <= low) continue;
    upper.emplace_back(frame.scan.points[i].position().head<2>());
  }
  return upper.size() >= kMinUpper ? upper : seenFromAbove(frame, segment.points);
}

bool isInOneOf(const std::vector<Volume>& volumes, const Eigen::Vector3f& place, float margin) {
  return std::any_of(volumes.begin(), volumes.end(),
                     [&](const Volume& volume) { return volume.contains(place, margin); });
}

/// True when volumes, with the margin, contain most of a segment.
bool enclose(const std::vector<Volume>& volumes,
             const KeyFrame& frame,
             const Segment& segment,
             float margin) {
  const auto inside = std::count_if(
      segment.points.begin(), segment.points.end(),
      [&](std::uint32_t i) { return isInOneOf(volumes, frame.scan.points[i].position(), margin); });
  return static_cast<double>(inside) >= kEnclosed * static_cast<double>(segment.points.size());
}

/// True for what nothing proves to stand: the votes left it static, but few found it again.
bool isUnproven(const Instance& instance, const DynamicConfig& config) {
  const bool by_votes = instance.reason == Reason::kVotes || instance.reason == Reason::kNoEvidence;
  return !instance.dynamic && by_votes &&
         instance.static_votes < static_cast<std::uint32_t>(config.keep_hits);
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
        margin_(static_cast<float>(config.foot_margin)),
        ground_(frame, places, areaOf(segment)),
        footprint_(upperPoints(frame, segment, ground_, top_)) {}

  /// True for a point of the ground around, whatever it was taken for.
  bool isGround(std::uint32_t i) const {
    const float height = ground_.heightOf(i);
    return height < bottom_ || (height < top_ && !isUnder(i));
  }
  /// True for a point of the object that was taken for ground.
  bool isFoot(std::uint32_t i) const { return ground_.heightOf(i) >= bottom_ && isUnder(i); }
  /// What isUnder can be true for.
  Eigen::AlignedBox2f area() const { return footprint_.bounds(margin_); }

 private:
  bool isUnder(std::uint32_t i) const {
    return footprint_.contains(frame_.scan.points[i].position().head<2>(), margin_);
  }

  const KeyFrame& frame_;
  float top_;
  float bottom_;
  float margin_;
  LocalGround ground_;
  Footprint footprint_;
};

/// Which points of no instance are removed.
class LooseRule {
 public:
  LooseRule(const KeyFrame& frame, const DynamicConfig& config)
      : frame_(frame), config_(config), moving_(dynamicVolumes(frame)) {}

  bool takes(std::uint32_t i, const PlaceEvidence& e) const {
    const Eigen::Vector3f place = frame_.scan.points[i].position();
    const auto height = static_cast<double>(frame_.seg.height[i]);
    const bool doubtful = e.free >= e.hit;
    if (doubtful && height >= config_.foot_bottom &&
        (isInOneOf(moving_, place, kBeside) || isInOneOf(frame_.swept, place, kSwept))) {
      return true;
    }
    // Kerbs are looked at so flatly that a small tilt of the pose makes them seem passed through.
    if (e.free == 0 || height < config_.foot_height) return false;
    const bool enough = e.free >= config_.loose_votes && e.free >= kFreeRatio * e.hit;
    return enough || (doubtful && isInOneOf(moving_, place, kNear));
  }

 private:
  const KeyFrame& frame_;
  const DynamicConfig& config_;
  std::vector<Volume> moving_;
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

void removeEnclosed(KeyFrame& frame, const DynamicConfig& config) {
  const std::vector<Volume> moving = dynamicVolumes(frame);
  const auto margin = static_cast<float>(config.foot_margin);
  for (std::size_t s = 0; s < frame.instances.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (!isUnproven(instance, config) || !enclose(moving, frame, frame.seg.segments[s], margin))
      continue;
    instance.dynamic = true;
    instance.reason = Reason::kEnclosed;
  }
}

void removeLoosePoints(KeyFrame& frame, const DynamicConfig& config) {
  const LooseRule rule(frame, config);
  const FrameEvidence& evidence = *frame.evidence;
  const std::size_t loose = evidence.begin.size() - 2;
  for (std::uint32_t k = evidence.begin[loose]; k < evidence.begin[loose + 1]; ++k) {
    const std::uint32_t i = evidence.listed[evidence.first[k]];
    if (rule.takes(i, evidence.answer(k))) frame.removed.push_back(i);
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

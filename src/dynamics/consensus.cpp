// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/consensus.hpp"

#include <algorithm>

#include "segdf/dynamics/evidence.hpp"

namespace segdf {

namespace {

constexpr int kSay = 6;               // frames, of ten
constexpr double kAgree = 0.7;        // share of these
constexpr double kWhole = 0.9;        // share of the points there
constexpr double kOther = 0.5;        // points of another object, for each point of the view
constexpr double kPlaceMargin = 0.3;  // metres

/// Where the segment stands, seen from above, map frame.
Eigen::AlignedBox2d placeOf(const KeyFrame& frame, const Segment& segment) {
  const UprightBox& box = segment.box;
  const Eigen::Rotation2Df turn(box.yaw);
  Eigen::AlignedBox2d place;
  for (const float x : {-0.5F, 0.5F}) {
    for (const float y : {-0.5F, 0.5F}) {
      Eigen::Vector3f corner = box.center;
      corner.head<2>() += turn * Eigen::Vector2f(x * box.size.x(), y * box.size.y());
      place.extend((frame.scan.pose * corner.cast<double>()).head<2>());
    }
  }
  return place;
}

bool isSamePlace(const Eigen::AlignedBox2d& a, const Eigen::AlignedBox2d& b) {
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kPlaceMargin);
  return Eigen::AlignedBox2d(a.min() - margin, a.max() + margin).intersects(b);
}

}  // namespace

Consensus::FrameViews Consensus::viewsOf(const KeyFrame& frame) {
  FrameViews seen{frame.index, {}, {}};
  for (std::size_t s = 0; s < frame.instances.size(); ++s) {
    const Instance& instance = frame.instances[s];
    const Segment& segment = frame.seg.segments[s];
    const bool is_part = s >= frame.evidence->votes.size();
    const std::uint32_t track = is_part ? instance.parent : instance.id;
    seen.views.push_back({track, placeOf(frame, segment), segment.points.size(), instance.dynamic});
    if (instance.dynamic) seen.moving.push_back(track);
  }
  std::sort(seen.moving.begin(), seen.moving.end());
  return seen;
}

void Consensus::note(const KeyFrame& frame) { frames_.push_back(viewsOf(frame)); }

bool Consensus::standsInPlaceOf(const View& view, const View& other) {
  return other.track != view.track && !other.dynamic &&
         static_cast<double>(other.points) >= kOther * static_cast<double>(view.points) &&
         other.place.contains(view.place.center());
}

Consensus::Say Consensus::say(const FrameViews& frame, const View& view) {
  std::size_t points = 0;
  std::size_t dynamic = 0;
  for (const View& other : frame.views) {
    if (standsInPlaceOf(view, other)) return Say::kStands;
    if (other.track != view.track || !isSamePlace(other.place, view.place)) continue;
    points += other.points;
    dynamic += other.dynamic ? other.points : 0;
  }
  if (points == 0) return Say::kNothing;
  return static_cast<double>(dynamic) >= kWhole * static_cast<double>(points) ? Say::kGoes
                                                                              : Say::kStands;
}

bool Consensus::goes(std::size_t here, const View& view) const {
  const std::size_t first = here - std::min(here, kFramesAround);
  const std::size_t last = std::min(here + kFramesAround, frames_.size() - 1);
  int moving = 0;
  for (std::size_t k = first; k <= last; ++k) {
    const std::vector<std::uint32_t>& tracks = frames_[k].moving;
    moving += std::binary_search(tracks.begin(), tracks.end(), view.track) ? 1 : 0;
  }
  if (moving < kAgree * kSay) return false;  // soon told, and of most
  int said = 0;
  int going = 0;
  bool after = false;
  for (std::size_t k = first; k <= last; ++k) {
    if (k == here) continue;
    const Say word = say(frames_[k], view);
    said += word != Say::kNothing ? 1 : 0;
    going += word == Say::kGoes ? 1 : 0;
    after = after || (word == Say::kGoes && k > here);
  }
  return said >= kSay && going >= kAgree * said && after;
}

void Consensus::apply(KeyFrame& frame) {
  const auto found =
      std::find_if(frames_.begin(), frames_.end(),
                   [&frame](const FrameViews& views) { return views.scan == frame.index; });
  const auto here = static_cast<std::size_t>(found - frames_.begin());
  for (std::size_t s = 0; s < found->views.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (instance.dynamic || !goes(here, found->views[s])) continue;
    instance.dynamic = true;
    instance.reason = Reason::kConsensus;
  }
  if (here >= kFramesAround) frames_.pop_front();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/departure.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/size_match.hpp"

namespace segdf {

namespace {

constexpr std::size_t kLeastPoints = 15;  // fewer have no size
// What lies lower is seen where a ray meets it, and that goes along with the sensor.
constexpr float kLeastTop = 0.5F;    // metres above the ground
constexpr double kLeastWay = 1.0;    // metres
constexpr double kOverlap = 0.5;     // metres of the greater length that the places may share
constexpr std::size_t kBetween = 4;  // frames between the two that are looked at
constexpr double kOffWay = 0.25;     // of the way that these may be off it
constexpr double kFarther = 1.1;     // of the range: what is seen there is seen here
constexpr double kReturned = 0.05;   // share of the places, by chance
// Of the places: rays that pass before the lower ones end on the road.
constexpr double kHidden = 0.6;

/// An instance as one frame has it.
struct View {
  const KeyFrame* frame;
  std::size_t index;  ///< of its segment

  const Segment& segment() const { return frame->seg.segments[index]; }
  const Eigen::Vector3f& size() const { return segment().box.size; }
  std::uint32_t id() const { return frame->instances[index].id; }
  Eigen::Vector2d center() const { return centerOf(*frame, index).head<2>(); }
};

bool mayMove(const View& view) {
  return view.segment().points.size() >= kLeastPoints && isTested(view.segment().object_class) &&
         isMoverSized(view.size()) && view.segment().features[Feature::kTop] >= kLeastTop;
}

/// True when what may move may be one object in two places.
bool areApart(const View& a, const View& b) {
  if (!isSameSize(a.size(), b.size())) return false;
  const auto length = static_cast<double>(std::max(a.size().x(), b.size().x()));
  return (b.center() - a.center()).norm() >= std::max(kLeastWay, length - kOverlap);
}

/// True when `view`, of a frame between those of `a` and `b`, is where a steady way leads.
bool isOnWay(const View& view, const View& a, const View& b) {
  const double begin = a.frame->evidence->time;
  const double share = (view.frame->evidence->time - begin) / (b.frame->evidence->time - begin);
  const Eigen::Vector2d way = b.center() - a.center();
  return (view.center() - a.center() - share * way).norm() <= kOffWay * way.norm();
}

/// An id that passes on from one thing that stands to another jumps. One of the frames between may
/// have lost it.
bool isSteady(const Window& window, std::size_t older, const View& a, const View& b) {
  const std::size_t steps = window.size() - 1 - older;
  const std::size_t looks = std::min(steps - 1, kBetween);
  std::size_t seen = 0;
  for (std::size_t k = 1; k <= looks; ++k) {
    const KeyFrame& frame = *window[older + k * steps / (looks + 1)];
    const auto instance = std::find_if(frame.instances.begin(), frame.instances.end(),
                                       [&a](const Instance& other) { return other.id == a.id(); });
    if (instance == frame.instances.end()) continue;
    const auto index = static_cast<std::size_t>(instance - frame.instances.begin());
    if (!isOnWay({&frame, index}, a, b)) return false;
    ++seen;
  }
  return seen > 0 && seen + 1 >= looks;
}

/// True when nothing returned from where `view` was, and hardly anything hid it.
bool isEmpty(const View& view, const KeyFrame& other, const Pose& other_T_view) {
  const FrameEvidence& evidence = *view.frame->evidence;
  const std::uint32_t first = evidence.begin[view.index];
  const std::uint32_t count = evidence.begin[view.index + 1] - first;
  std::vector<VolumetricState> states(count);
  other.evidence->image.look(evidence.places.middleRows(first, count), other_T_view.cast<float>(),
                             states.data());
  const auto share = [&states](VolumetricState state) {
    return static_cast<double>(std::count(states.begin(), states.end(), state)) /
           static_cast<double>(states.size());
  };
  return share(VolumetricState::kHit) <= kReturned && share(VolumetricState::kOccluded) <= kHidden;
}

/// Lets the frame that has `now` vote on `view`.
void voteOn(const View& view, const View& now, const Pose& now_T_view) {
  const auto range = static_cast<double>(now.segment().box.center.norm());
  const Eigen::Vector3d place = now_T_view * view.segment().box.center.cast<double>();
  if (place.norm() > kFarther * range || !isEmpty(view, *now.frame, now_T_view)) return;
  std::vector<PairVote>& votes = view.frame->evidence->votes[view.index];
  const std::size_t scan = now.frame->index;
  auto vote = std::find_if(votes.begin(), votes.end(),
                           [scan](const PairVote& other) { return other.scan == scan; });
  if (vote == votes.end()) vote = votes.insert(votes.end(), PairVote{});
  vote->scan = scan;
  vote->seconds = static_cast<float>(now.frame->evidence->time - view.frame->evidence->time);
  vote->free = static_cast<std::uint32_t>(view.segment().points.size());
  vote->hit = 0;
  vote->informative = true;
  vote->departure = true;
}

}  // namespace

void noteDepartures(const Window& window, const std::vector<ComparedPair>& pairs) {
  const KeyFrame& newest = *window.back();
  std::map<std::uint32_t, View> views;
  for (std::size_t s = 0; s < newest.instances.size(); ++s) {
    const View view{&newest, s};
    if (mayMove(view)) views.emplace(view.id(), view);
  }
  for (const ComparedPair& pair : pairs) {
    const KeyFrame& older = *window[pair.older];
    for (std::size_t s = 0; s < older.instances.size(); ++s) {
      const View then{&older, s};
      if (!mayMove(then)) continue;
      const auto now = views.find(then.id());
      if (now == views.end() || !areApart(then, now->second)) continue;
      if (!isSteady(window, pair.older, then, now->second)) continue;
      voteOn(then, now->second, pair.older_T_newest.inverse());
      voteOn(now->second, then, pair.older_T_newest);
    }
  }
}

}  // namespace segdf

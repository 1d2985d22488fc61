// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/place_memory.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/pose_refinement.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr std::size_t kStands = 2048;    // remembered at most
constexpr std::size_t kEnough = 1000;    // points, to register a view by
constexpr std::size_t kMinPoints = 20;   // of an instance, and of its places
constexpr std::size_t kMaxPlaces = 128;  // of one instance: more tell nothing new
constexpr float kOverGround = 0.4F;      // metres: the ground is found again where a car has left
constexpr double kMuchBetter = 1.5;      // times the points: worth another view
constexpr double kSamePlace = 1.0;       // metres: as far as the centres of views of a car differ
constexpr double kReach = 40.0;          // metres, of a look
constexpr double kLookStep = 0.5;        // seconds between looks that may see through it
constexpr double kFoundStep = 2.0;       // seconds after it was found again
constexpr double kFoundAgain = 0.5;      // share of what is seen
// Share of points that must fit. Pairs of frames of one street have 0.87 and more, a minute apart
// and with noise of 0.1 m in their poses; where poses have drifted too far to be refined, half have
// 0.33 or less.
constexpr double kQuality = 0.8;
constexpr double kSameVisit = 10.0;  // seconds: places seen so close in time drift as one
constexpr std::size_t kFoundPerFree = 3;

/// Some points of the instance, a row each, sensor frame.
Eigen::MatrixX3f placesOf(const KeyFrame& frame, const Segment& segment) {
  std::vector<std::uint32_t> high;
  for (std::uint32_t i : segment.points) {
    if (frame.seg.height[i] >= kOverGround) high.push_back(i);
  }
  const std::size_t stride = high.size() / kMaxPlaces + 1;
  Eigen::MatrixX3f places(static_cast<Eigen::Index>((high.size() + stride - 1) / stride), 3);
  for (Eigen::Index k = 0; k < places.rows(); ++k) {
    places.row(k) = frame.scan.points[high[static_cast<std::size_t>(k) * stride]].position();
  }
  return places;
}

bool standsStill(const KeyFrame& frame, std::size_t s, const DynamicConfig& config) {
  const Segment& segment = frame.seg.segments[s];
  return !frame.instances[s].dynamic && isTested(segment.object_class) &&
         segment.points.size() >= kMinPoints && isMoverSized(segment.box.size) &&
         isParked(frame.evidence->votes[s], segment.points.size(), config);
}

/// Adds an instance to what would be revoked.
void extend(std::vector<Revocation>& runs,
            const KeyFrame& frame,
            std::size_t s,
            const Eigen::Vector3d& center) {
  const std::uint32_t id = frame.instances[s].id;
  if (runs.empty() || runs.back().id != id) {
    runs.emplace_back();
    runs.back().id = id;
    runs.back().first = frame.index;
  }
  Revocation& run = runs.back();
  run.last = frame.index;
  ++run.frames;
  run.points += frame.seg.segments[s].points.size();
  run.object_class = frame.seg.segments[s].object_class;
  run.center = center;
}

}  // namespace

void PlaceMemory::note(const KeyFrame& frame) {
  std::shared_ptr<const View> view;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    if (standsStill(frame, s, config_)) remember(frame, s, view);
  }
  if (stands_.size() > kStands) {
    stands_.erase(stands_.begin(), stands_.end() - static_cast<std::ptrdiff_t>(kStands));
  }
}

PlaceMemory::Stand* PlaceMemory::standOf(const KeyFrame& frame,
                                         std::size_t segment,
                                         const Eigen::Vector3d& center) {
  const Eigen::Vector3f& size = frame.seg.segments[segment].box.size;
  Stand* found = nullptr;
  double nearest = kSamePlace;
  for (Stand& stand : stands_) {
    const double distance = (stand.center - center).norm();
    const bool same =
        stand.runs.back().id == frame.instances[segment].id || isSameSize(stand.size, size);
    if (!same || distance > nearest) continue;
    nearest = distance;
    found = &stand;
  }
  return found;
}

void PlaceMemory::remember(const KeyFrame& frame,
                           std::size_t segment,
                           std::shared_ptr<const View>& view) {
  const Segment& seen = frame.seg.segments[segment];
  const Eigen::Vector3d center = centerOf(frame, segment);
  Stand* stand = standOf(frame, segment, center);
  const bool better = stand == nullptr || static_cast<double>(seen.points.size()) >=
                                              kMuchBetter * static_cast<double>(stand->points);
  Eigen::MatrixX3f places = better ? placesOf(frame, seen) : Eigen::MatrixX3f();
  if (static_cast<std::size_t>(places.rows()) >= kMinPoints) {
    if (!view) view = std::make_shared<const View>(viewOf(frame));
    if (stand == nullptr) stand = &stands_.emplace_back();
    stand->center = center;
    stand->size = seen.box.size;
    stand->points = seen.points.size();
    stand->view = view;
    stand->places = std::move(places);
  }
  if (stand != nullptr) extend(stand->runs, frame, segment, center);
}

PlaceMemory::View PlaceMemory::viewOf(const KeyFrame& frame) {
  View view{frame.evidence->time, frame.scan.pose, {}};
  const std::vector<Eigen::Vector3f>& points = frame.evidence->registration_points;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kEnough);
  for (std::size_t k = 0; k < points.size(); k += stride) {
    view.registration_points.push_back(points[k]);
  }
  return view;
}

void PlaceMemory::look(const KeyFrame& newest) {
  std::vector<Answer> answers = askAround(newest);
  std::vector<std::size_t> left;
  for (const Answer& answer : answers) {
    Stand& stand = stands_[answer.stand];
    if (!answer.fresh) continue;
    stand.free_looks = answer.free && isTrusted(answer, answers) ? stand.free_looks + 1 : 0;
    if (stand.free_looks >= config_.left_looks) left.push_back(answer.stand);
  }
  for (auto k = left.rbegin(); k != left.rend(); ++k) {
    const auto stand = stands_.begin() + static_cast<std::ptrdiff_t>(*k);
    revoked_.insert(revoked_.end(), stand->runs.begin(), stand->runs.end());
    stands_.erase(stand);
  }
}

std::vector<PlaceMemory::Answer> PlaceMemory::askAround(const KeyFrame& newest) {
  const double now = newest.evidence->time;
  std::map<const View*, PairPose> poses;  // for look-up only
  const auto pose_of = [&](const View& view) {
    const auto [place, fresh] = poses.try_emplace(&view);
    if (fresh) {
      place->second = refinePair(newest.scan.pose.inverse() * view.pose, view.registration_points,
                                 newest.evidence->planes);
    }
    return place->second;
  };
  std::vector<Answer> answers;
  for (std::size_t k = 0; k < stands_.size(); ++k) {
    Stand& stand = stands_[k];
    if ((stand.center - newest.scan.pose.translation()).norm() > kReach) continue;
    if (now < stand.next_look) {
      answers.push_back({k, stand.free_looks > 0, false});
      continue;
    }
    stand.next_look = now + kLookStep;
    const PairPose pose = pose_of(*stand.view);
    if (pose.quality < kQuality) continue;
    const VolumetricState state = stateOf(stand, newest, pose.to_T_from);
    if (state == VolumetricState::kUnknown) continue;
    if (state == VolumetricState::kHit) stand.next_look = now + kFoundStep;
    answers.push_back({k, state == VolumetricState::kFree, true});
  }
  return answers;
}

bool PlaceMemory::isTrusted(const Answer& answer, const std::vector<Answer>& answers) const {
  const double time = stands_[answer.stand].view->time;
  std::size_t found = 0;
  std::size_t free = 0;
  for (const Answer& other : answers) {
    if (std::abs(stands_[other.stand].view->time - time) > kSameVisit) continue;
    ++(other.free ? free : found);
  }
  return found >= kFoundPerFree * free;
}

VolumetricState PlaceMemory::stateOf(const Stand& stand,
                                     const KeyFrame& newest,
                                     const Pose& newest_T_view) const {
  std::vector<VolumetricState> states(static_cast<std::size_t>(stand.places.rows()));
  newest.evidence->image.look(stand.places, newest_T_view.cast<float>(), states.data());
  const auto free = std::count(states.begin(), states.end(), VolumetricState::kFree);
  const auto hit = std::count(states.begin(), states.end(), VolumetricState::kHit);
  const auto seen = static_cast<double>(free + hit);
  const double least = std::max(static_cast<double>(config_.vis_min),
                                config_.vis_frac * static_cast<double>(states.size()));
  if (seen < least) return VolumetricState::kUnknown;
  if (static_cast<double>(free) >= config_.f_single * seen) return VolumetricState::kFree;
  if (static_cast<double>(hit) >= kFoundAgain * seen) return VolumetricState::kHit;
  return VolumetricState::kUnknown;
}

std::vector<Revocation> PlaceMemory::takeRevocations() { return std::exchange(revoked_, {}); }

void PlaceMemory::forget() { stands_.clear(); }

}  // namespace segdf

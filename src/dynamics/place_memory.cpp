// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/place_memory.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/pose_refinement.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr std::size_t kStands = 4096;    // remembered at most
constexpr std::size_t kMinPoints = 20;   // of an instance, and of its places
constexpr std::size_t kMaxPlaces = 128;  // of one instance: more tell nothing new
constexpr float kOverGround = 0.4F;      // metres: the ground is found again where a car has left
constexpr double kMuchBetter = 1.5;      // times the points: worth another view
constexpr double kSamePlace = 1.0;       // metres: as far as the centres of views of a car differ
constexpr double kReach = 40.0;          // metres, of a look
constexpr double kLookStep = 0.5;        // seconds between looks that may see through it
constexpr double kFoundStep = 2.0;       // seconds after it was found again
constexpr double kFoundAgain = 0.5;      // share of what is seen

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
  const Eigen::Vector3d center = frame.scan.pose * seen.box.center.cast<double>();
  Stand* stand = standOf(frame, segment, center);
  const bool better = stand == nullptr || static_cast<double>(seen.points.size()) >=
                                              kMuchBetter * static_cast<double>(stand->points);
  if (better) {
    Eigen::MatrixX3f places = placesOf(frame, seen);
    if (static_cast<std::size_t>(places.rows()) >= kMinPoints) {
      if (!view) {
        view = std::make_shared<const View>(
            View{frame.scan.pose, frame.evidence->registration_points});
      }
      if (stand == nullptr) {
        stands_.emplace_back();
        stand = &stands_.back();
      }
      stand->center = center;
      stand->size = seen.box.size;
      stand->points = seen.points.size();
      stand->view = view;
      stand->places = std::move(places);
    }
  }
  if (stand != nullptr) extend(stand->runs, frame, segment, center);
}

std::vector<std::size_t> PlaceMemory::due(const KeyFrame& newest) const {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < stands_.size(); ++k) {
    const bool near = (stands_[k].center - newest.scan.pose.translation()).norm() <= kReach;
    if (near && newest.evidence->time >= stands_[k].next_look) places.push_back(k);
  }
  return places;
}

void PlaceMemory::look(const KeyFrame& newest) {
  std::map<const View*, PairPose> poses;  // for look-up only
  std::vector<std::size_t> left;
  for (std::size_t k : due(newest)) {
    Stand& stand = stands_[k];
    const View& view = *stand.view;
    auto pose = poses.find(&view);
    if (pose == poses.end()) {
      const Pose given = newest.scan.pose.inverse() * view.pose;
      const PairPose refined = refinePair(given, view.registration_points, newest.evidence->planes);
      pose = poses.emplace(&view, refined).first;
    }
    stand.next_look = newest.evidence->time + kLookStep;
    if (pose->second.quality >= config_.min_quality) judge(newest, pose->second.to_T_from, stand);
    if (stand.free_looks >= config_.left_looks) left.push_back(k);
  }
  for (auto k = left.rbegin(); k != left.rend(); ++k) {
    const auto stand = stands_.begin() + static_cast<std::ptrdiff_t>(*k);
    revoked_.insert(revoked_.end(), stand->runs.begin(), stand->runs.end());
    stands_.erase(stand);
  }
}

void PlaceMemory::judge(const KeyFrame& newest, const Pose& newest_T_view, Stand& stand) const {
  std::vector<VolumetricState> states(static_cast<std::size_t>(stand.places.rows()));
  newest.evidence->image.look(stand.places, newest_T_view.cast<float>(), states.data());
  const auto free = std::count(states.begin(), states.end(), VolumetricState::kFree);
  const auto hit = std::count(states.begin(), states.end(), VolumetricState::kHit);
  const auto seen = static_cast<double>(free + hit);
  const double least = std::max(static_cast<double>(config_.vis_min),
                                config_.vis_frac * static_cast<double>(states.size()));
  if (seen < least) return;
  if (static_cast<double>(free) >= config_.f_single * seen) {
    ++stand.free_looks;
  } else if (static_cast<double>(hit) >= kFoundAgain * seen) {
    stand.free_looks = 0;
    stand.next_look = newest.evidence->time + kFoundStep;
  }
}

std::vector<Revocation> PlaceMemory::takeRevocations() { return std::exchange(revoked_, {}); }

void PlaceMemory::forget() { stands_.clear(); }

}  // namespace segdf

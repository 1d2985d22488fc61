// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/track_vote.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr std::size_t kProofs = 2;
constexpr std::size_t kStrongProofs = 8;  // outweigh that the instance stands here
constexpr std::size_t kKeptProofs = 32;   // more of the past tell nothing new

using Sizes = TrackBook::Sizes;

/// Sizes of the instances in the window that the votes make dynamic so far.
Sizes proofsIn(const Window& window, const DynamicConfig& config) {
  Sizes proofs;
  for (const KeyFrame* frame : window) {
    for (std::size_t s = 0; s < frame->evidence->votes.size(); ++s) {
      const Segment& segment = frame->seg.segments[s];
      if (!judgeVotes(frame->evidence->votes[s], segment.object_class, config).dynamic) continue;
      proofs[frame->instances[s].id].push_back(segment.box.size);
    }
  }
  return proofs;
}

/// Proofs that a condition holds for.
template <class Condition>
std::size_t countProofs(const Sizes& proofs, std::uint32_t id, const Condition& condition) {
  const auto track = proofs.find(id);
  if (track == proofs.end()) return 0;
  return static_cast<std::size_t>(
      std::count_if(track->second.begin(), track->second.end(), condition));
}

}  // namespace

void TrackBook::propagate(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  const Sizes present = proofsIn(window, config_);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (instance.dynamic) continue;
    const Segment& segment = frame.seg.segments[s];
    const Eigen::Vector3f& size = segment.box.size;
    bool moves = false;
    if (!isParked(frame.evidence->votes[s], segment.points.size(), config_)) {
      moves = countProofs(present, instance.id, [&size](const Eigen::Vector3f& proof) {
                return isSameSize(proof, size);
              }) >= kProofs;
    } else if (config_.semi_static == SemiStatic::kRemove) {
      const auto part = [&size](const Eigen::Vector3f& proof) { return isPartOf(proof, size); };
      moves = countProofs(present, instance.id, part) + countProofs(past_, instance.id, part) >=
              kStrongProofs;
    }
    if (!moves) continue;
    instance.dynamic = true;
    instance.reason = Reason::kTrack;
  }
}

void TrackBook::note(const KeyFrame& frame) {
  std::set<std::uint32_t> seen;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    seen.insert(instance.id);
    if (!instance.dynamic || instance.reason != Reason::kVotes) continue;
    std::vector<Eigen::Vector3f>& proofs = past_[instance.id];
    if (proofs.size() < kKeptProofs) proofs.push_back(frame.seg.segments[s].box.size);
  }
  for (auto track = past_.begin(); track != past_.end();) {
    track = seen.count(track->first) != 0 ? std::next(track) : past_.erase(track);
  }
}

}  // namespace segdf

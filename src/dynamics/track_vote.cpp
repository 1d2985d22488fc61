// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/track_vote.hpp"

#include <algorithm>
#include <iterator>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr std::size_t kProofs = 2;
constexpr std::size_t kStrongProofs = 8;  // outweigh that the instance stands here
constexpr std::size_t kKeptProofs = 32;   // more of the past tell nothing new
constexpr float kSizeRatio = 1.3F;
constexpr float kSizeSlack = 0.3F;  // metres

bool isSimilar(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Array3f larger = a.array().max(b.array());
  const Eigen::Array3f smaller = a.array().min(b.array());
  return (larger <= kSizeRatio * smaller + kSizeSlack).all();
}

using Sizes = std::map<std::uint32_t, std::vector<Eigen::Vector3f>>;  // by id

/// Sizes of the instances in the window that the votes make dynamic so far.
Sizes proofsIn(const Window& window, const DynamicConfig& config) {
  Sizes proofs;
  for (const KeyFrame* frame : window) {
    for (std::size_t s = 0; s < frame->evidence->votes.size(); ++s) {
      if (!judgeVotes(frame->evidence->votes[s], config).dynamic) continue;
      proofs[frame->instances[s].id].push_back(frame->seg.segments[s].box.size);
    }
  }
  return proofs;
}

}  // namespace

std::size_t TrackBook::proofsFor(const std::vector<Eigen::Vector3f>& proofs,
                                 const Eigen::Vector3f& size) const {
  return static_cast<std::size_t>(
      std::count_if(proofs.begin(), proofs.end(),
                    [&size](const Eigen::Vector3f& proof) { return isSimilar(proof, size); }));
}

void TrackBook::propagate(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  const Sizes present = proofsIn(window, config_);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (instance.dynamic) continue;
    const Segment& segment = frame.seg.segments[s];
    const auto now = present.find(instance.id);
    const auto before = past_.find(instance.id);
    std::size_t proofs = now == present.end() ? 0 : proofsFor(now->second, segment.box.size);
    const bool parked = isParked(frame.evidence->votes[s], segment.points.size(), config_);
    if (parked && before != past_.end()) {
      proofs += proofsFor(before->second.proofs, segment.box.size);
    }
    const bool overruled = config_.semi_static == SemiStatic::kRemove && proofs >= kStrongProofs;
    if (proofs < kProofs || (parked && !overruled)) continue;
    instance.dynamic = true;
    instance.reason = Reason::kTrack;
  }
}

void TrackBook::note(const KeyFrame& frame) {
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    const bool proof = instance.dynamic && instance.reason == Reason::kVotes;
    const auto found = past_.find(instance.id);
    if (!proof && found == past_.end()) continue;
    Track& track = found == past_.end() ? past_[instance.id] : found->second;
    track.last_scan = frame.index;
    if (proof && track.proofs.size() < kKeptProofs) {
      track.proofs.push_back(frame.seg.segments[s].box.size);
    }
  }
  for (auto track = past_.begin(); track != past_.end();) {
    track = track->second.last_scan == frame.index ? std::next(track) : past_.erase(track);
  }
}

}  // namespace segdf

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
constexpr std::size_t kKeptProofs = 64;   // the latest of the past

constexpr double kElsewhere = 2.0;  // metres: farther than views of one car differ

using Proof = TrackBook::Proof;
using Proofs = TrackBook::Proofs;

Proof proofOf(const KeyFrame& frame, std::size_t segment) {
  const UprightBox& box = frame.seg.segments[segment].box;
  return {frame.index, box.size, frame.scan.pose * box.center.cast<double>()};
}

/// The instances in the window that the votes make dynamic so far.
Proofs proofsIn(const Window& window, const DynamicConfig& config) {
  Proofs proofs;
  for (const KeyFrame* frame : window) {
    for (std::size_t s = 0; s < frame->evidence->votes.size(); ++s) {
      const ObjectClass object_class = frame->seg.segments[s].object_class;
      if (!judgeVotes(frame->evidence->votes[s], object_class, config).dynamic) continue;
      proofs[frame->instances[s].id].push_back(proofOf(*frame, s));
    }
  }
  return proofs;
}

const std::vector<Proof>& proofsOf(const Proofs& proofs, std::uint32_t id) {
  static const std::vector<Proof> none;
  const auto track = proofs.find(id);
  return track == proofs.end() ? none : track->second;
}

template <class Condition>
std::size_t countProofs(const std::vector<Proof>& proofs, const Condition& condition) {
  return static_cast<std::size_t>(std::count_if(proofs.begin(), proofs.end(), condition));
}

/// True when frames in which the track was elsewhere found the segment here.
bool standsApart(const KeyFrame& frame,
                 std::size_t segment,
                 const std::vector<Proof>& past,
                 const std::vector<Proof>& present,
                 const DynamicConfig& config) {
  const Proof here = proofOf(frame, segment);
  const double apart = std::max(kElsewhere, 0.5 * static_cast<double>(here.size.x()));
  const std::size_t points = frame.seg.segments[segment].points.size();
  int contradictions = 0;
  for (const PairVote& vote : frame.evidence->votes[segment]) {
    if (!isFoundAgain(vote, points, config)) continue;
    const auto contradicts = [&](const Proof& proof) {
      return proof.scan == vote.scan && (proof.center - here.center).norm() > apart;
    };
    contradictions += std::any_of(past.begin(), past.end(), contradicts) ||
                      std::any_of(present.begin(), present.end(), contradicts);
  }
  return contradictions >= config.keep_hits;
}

}  // namespace

bool TrackBook::moves(const KeyFrame& frame, std::size_t s, const Proofs& present) const {
  const std::uint32_t id = frame.instances[s].id;
  const Segment& segment = frame.seg.segments[s];
  const Eigen::Vector3f& size = segment.box.size;
  const std::vector<Proof>& proofs = proofsOf(present, id);
  if (!isParked(frame.evidence->votes[s], segment.points.size(), config_)) {
    return countProofs(proofs, [&size](const Proof& proof) {
             return isSameSize(proof.size, size);
           }) >= kProofs;
  }
  if (config_.semi_static != SemiStatic::kRemove) return false;
  const auto part = [&size](const Proof& proof) { return isPartOf(proof.size, size); };
  const std::vector<Proof>& past = proofsOf(past_, id);
  if (countProofs(past, part) + countProofs(proofs, part) < kStrongProofs) return false;
  return !standsApart(frame, s, past, proofs, config_);
}

void TrackBook::propagate(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  const Proofs present = proofsIn(window, config_);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (instance.dynamic || !moves(frame, s, present)) continue;
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
    std::vector<Proof>& proofs = past_[instance.id];
    if (proofs.size() == kKeptProofs) proofs.erase(proofs.begin());
    proofs.push_back(proofOf(frame, s));
  }
  for (auto track = past_.begin(); track != past_.end();) {
    track = seen.count(track->first) != 0 ? std::next(track) : past_.erase(track);
  }
}

}  // namespace segdf

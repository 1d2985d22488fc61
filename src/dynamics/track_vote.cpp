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

constexpr int kProofs = 2;
// Seconds of proven motion that outweigh that the instance stands here: eight scans at 10 Hz. A
// proof stands for the time since the key frame before, but for no more than a step: three are
// asked for, however far apart key frames are.
constexpr double kStrongSeconds = 0.75;
constexpr double kLongestStep = 0.3;
constexpr std::size_t kKeptProofs = 64;  // of the past: the first half, and the latest

// Seconds of motion elsewhere in scans that found the instance here: three scans at 10 Hz.
constexpr double kElsewhereSeconds = 0.25;
constexpr double kElsewhere = 2.0;  // metres: farther than views of one car differ
constexpr double kAway = 1.0;       // metres: farther than noise moves the centre of a view

using Proof = TrackBook::Proof;
using Proofs = TrackBook::Proofs;

bool isParkedHere(const KeyFrame& frame, std::size_t s, const DynamicConfig& config) {
  return isParked(frame.evidence->votes[s], frame.seg.segments[s].points.size(), config);
}

Proof proofOf(const KeyFrame& frame, std::size_t segment) {
  const UprightBox& box = frame.seg.segments[segment].box;
  return {frame.index, box.size, frame.scan.pose * box.center.cast<double>(),
          std::min(frame.evidence->step, kLongestStep)};
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

/// Seconds over which what may be a part of something of this size was proven to move.
double secondsOfMotion(const std::vector<Proof>& proofs, const Eigen::Vector3f& size) {
  double seconds = 0.0;
  for (const Proof& proof : proofs) {
    if (isPartOf(proof.size, size)) seconds += proof.seconds;
  }
  return seconds;
}

/// True when something moved where no view of the instance can have its centre. Parts of what
/// stands may seem seen through from afar, time and again from the place where the ego waits.
bool wentAway(const std::vector<Proof>& proofs, const Proof& here) {
  return std::any_of(proofs.begin(), proofs.end(), [&](const Proof& proof) {
    const float room = std::max(0.0F, here.size.x() - proof.size.y()) / 2.0F;
    return (proof.center - here.center).norm() > kAway + static_cast<double>(room);
  });
}

/// True when scans in which the track moved elsewhere found the segment here, for long enough.
bool standsApart(const KeyFrame& frame,
                 std::size_t segment,
                 const std::vector<Proof>& proofs,
                 const DynamicConfig& config) {
  const Proof here = proofOf(frame, segment);
  const double apart = std::max(kElsewhere, 0.5 * static_cast<double>(here.size.x()));
  const std::size_t points = frame.seg.segments[segment].points.size();
  double seconds = 0.0;
  for (const PairVote& vote : frame.evidence->votes[segment]) {
    if (!isFoundAgain(vote, points, config)) continue;
    const auto proof = std::find_if(proofs.begin(), proofs.end(), [&](const Proof& candidate) {
      return candidate.scan == vote.scan && (candidate.center - here.center).norm() > apart;
    });
    if (proof != proofs.end()) seconds += proof->seconds;
  }
  return seconds >= kElsewhereSeconds;
}

}  // namespace

bool TrackBook::moves(const KeyFrame& frame,
                      std::size_t s,
                      const std::vector<Proof>& past,
                      const std::vector<Proof>& present) const {
  const Eigen::Vector3f& size = frame.seg.segments[s].box.size;
  if (!isParkedHere(frame, s, config_)) {
    const auto alike = [&size](const Proof& proof) { return isSameSize(proof.size, size); };
    return std::count_if(present.begin(), present.end(), alike) >= kProofs;
  }
  if (config_.semi_static != SemiStatic::kRemove) return false;
  std::vector<Proof> proofs = past;
  proofs.insert(proofs.end(), present.begin(), present.end());
  return secondsOfMotion(proofs, size) >= kStrongSeconds && wentAway(proofs, proofOf(frame, s)) &&
         !standsApart(frame, s, proofs, config_);
}

void TrackBook::propagate(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  const Proofs present = proofsIn(window, config_);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    if (instance.dynamic) continue;
    std::vector<Proof> past = proofsOf(past_, instance.id);
    past.erase(
        std::lower_bound(past.begin(), past.end(), window.front()->index,
                         [](const Proof& proof, std::size_t scan) { return proof.scan < scan; }),
        past.end());
    if (!moves(frame, s, past, proofsOf(present, instance.id))) continue;
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
    if (proofs.size() == kKeptProofs) proofs.erase(proofs.begin() + kKeptProofs / 2);
    proofs.push_back(proofOf(frame, s));
  }
  for (auto track = past_.begin(); track != past_.end();) {
    track = seen.count(track->first) != 0 ? std::next(track) : past_.erase(track);
  }
}

}  // namespace segdf

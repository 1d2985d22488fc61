// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/track_vote.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/instance_links.hpp"
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
constexpr std::size_t kManyMembers = 8;
constexpr double kFewDynamic = 0.1;  // share of the members

constexpr double kElsewhere = 2.0;  // metres: farther than views of one car differ
constexpr int kFoundBeyond = 2;     // scans
constexpr int kOftenApart = 3;      // instances of an id that stood apart from what moved
constexpr double kAway = 1.0;       // metres: farther than noise moves the centre of a view

constexpr float kVehicle = 2.5F;  // metres: what is longer is neither walked nor ridden
constexpr float kWalker = 1.0F;   // metres: hardly any view of a vehicle is shorter
constexpr double kWalking = 3.0;  // m/s

using Proof = TrackBook::Proof;

bool isParkedHere(const KeyFrame& frame, std::size_t s, const DynamicConfig& config) {
  return isParked(frame.evidence->votes[s], frame.seg.segments[s].points.size(), config);
}

Proof proofOf(const KeyFrame& frame, std::size_t segment) {
  const UprightBox& box = frame.seg.segments[segment].box;
  return {frame.index, box.size, frame.scan.pose * box.center.cast<double>(),
          std::min(frame.evidence->step, kLongestStep),
          frame.instances[segment].velocity.head<2>().norm()};
}

/// True when hardly any member of the track moved, of many. A car that came and stopped is seen
/// through from before it came for seconds, and so are many of its members.
bool isOutvoted(std::size_t present_members,
                const std::vector<Proof>& present,
                const std::vector<Proof>& past) {
  const std::size_t dynamic = present.size() + past.size();
  const std::size_t members = present_members + past.size();
  return members >= kManyMembers &&
         static_cast<double>(dynamic) < kFewDynamic * static_cast<double>(members);
}

/// True when a proof may be another view of a thing that stands here. It is not longer; height and
/// width do not count, as what moved at a distance stands beside the sensor now, which sees a part
/// of its side. And who walks by a parked car, and was one with it for a while, is no view of it.
bool mayHaveStopped(const Eigen::Vector3f& size, const Proof& proof) {
  const bool walks = proof.size.x() < kWalker && proof.speed < kWalking;
  return proof.size.x() <= greatestView(size).x() && !(size.x() > kVehicle && walks);
}

/// True when the proof may be one of the segment's object: a part of it, or, where hardly anybody
/// found the segment again, what it is a part of; of what by its class cannot move (a hedge before
/// which somebody walks), what has its size.
bool mayBeOf(const Segment& segment, const Proof& proof, bool parked) {
  const Eigen::Vector3f& size = segment.box.size;
  if (!isTested(segment.object_class)) return isSameSize(proof.size, size);
  if (parked) return mayHaveStopped(size, proof);
  return isPartOf(proof.size, size) || isPartOf(size, proof.size);
}

/// Seconds over which the segment's object was proven to move.
double secondsOfMotion(const std::vector<Proof>& proofs, const Segment& segment, bool parked) {
  double seconds = 0.0;
  for (const Proof& proof : proofs) {
    if (mayBeOf(segment, proof, parked)) seconds += proof.seconds;
  }
  return seconds;
}

/// True when something moved where no view of the instance can have its centre. Parts of what
/// stands may seem seen through from afar, time and again from the place where the ego waits; what
/// has the size of the whole is no part.
bool wentAway(const std::vector<Proof>& proofs, const Proof& here) {
  return std::any_of(proofs.begin(), proofs.end(), [&](const Proof& proof) {
    const float room = isSameSize(proof.size, here.size)
                           ? 0.0F
                           : std::max(0.0F, here.size.x() - proof.size.y()) / 2.0F;
    return (proof.center - here.center).norm() > kAway + static_cast<double>(room);
  });
}

/// The track's proofs of motion that are farther from here than views of one object differ.
std::vector<Proof> elsewhere(const std::vector<Proof>& proofs, const Proof& here) {
  const double apart = std::max(kElsewhere, 0.5 * static_cast<double>(here.size.x()));
  std::vector<Proof> far;
  std::copy_if(proofs.begin(), proofs.end(), std::back_inserter(far),
               [&](const Proof& proof) { return (proof.center - here.center).norm() > apart; });
  return far;
}

/// True when the track moved elsewhere between the scan of the instance and another.
bool isBetween(const std::vector<Proof>& far, std::size_t scan, std::size_t other) {
  const auto [first, last] = std::minmax(scan, other);
  return std::any_of(far.begin(), far.end(), [first = first, last = last](const Proof& proof) {
    return proof.scan > first && proof.scan < last;
  });
}

/// True when scans in which the track moved elsewhere found the segment here, for long enough; or
/// when several did on the other side of such scans, and none saw through it: nothing leaves and
/// comes back to the same place unseen.
bool standsApart(const KeyFrame& frame,
                 std::size_t segment,
                 const std::vector<Proof>& proofs,
                 const DynamicConfig& config) {
  const std::vector<Proof> far = elsewhere(proofs, proofOf(frame, segment));
  const std::size_t points = frame.seg.segments[segment].points.size();
  double seconds = 0.0;
  int beyond = 0;
  bool seen_through = false;
  for (const PairVote& vote : frame.evidence->votes[segment]) {
    seen_through = seen_through || isSeenThrough(vote, config);
    if (!isFoundAgain(vote, points, config)) continue;
    const auto proof =
        std::find_if(far.begin(), far.end(), [&](const Proof& p) { return p.scan == vote.scan; });
    if (proof != far.end()) seconds += proof->seconds;
    beyond += isBetween(far, frame.index, vote.scan) ? 1 : 0;
  }
  return seconds >= kElsewhereSeconds || (beyond >= kFoundBeyond && !seen_through);
}

/// True when the track moved only later than the segment's scan, and no scan since it did saw
/// through the segment: what leaves opens its place. What drives by closely takes an id along, too.
bool staysBehind(const KeyFrame& frame,
                 std::size_t segment,
                 const std::vector<Proof>& proofs,
                 const DynamicConfig& config) {
  const std::size_t first = proofs.front().scan;
  const std::vector<PairVote>& votes = frame.evidence->votes[segment];
  return first > frame.index && std::none_of(votes.begin(), votes.end(), [&](const PairVote& vote) {
           return vote.scan >= first && isSeenThrough(vote, config);
         });
}

/// Of which instance, before which scan, one was a part.
struct Parent {
  std::uint32_t id = 0;
  std::size_t scan = 0;
};

std::map<std::uint32_t, Parent> parentsIn(const Window& window) {
  std::map<std::uint32_t, Parent> parents;
  for (const KeyFrame* frame : window) {
    for (std::size_t s = 0; s < frame->evidence->votes.size(); ++s) {
      const Instance& instance = frame->instances[s];
      if (instance.parent != 0) parents[instance.id] = {instance.parent, frame->index};
    }
  }
  return parents;
}

/// By id: which of a frame's ids inherit from it what it did before which scan.
using Heirs = std::multimap<std::uint32_t, Parent>;

Heirs heirsOf(const KeyFrame& frame, const Window& window) {
  const std::map<std::uint32_t, Parent> parents = parentsIn(window);
  Heirs heirs;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const std::uint32_t id = frame.instances[s].id;
    std::size_t before = frame.index;
    for (auto parent = parents.find(id); parent != parents.end();
         parent = parents.find(parent->second.id)) {
      before = std::min(before, parent->second.scan);
      heirs.emplace(parent->second.id, Parent{id, before});
    }
  }
  return heirs;
}

}  // namespace

bool TrackBook::moves(const KeyFrame& frame,
                      std::size_t s,
                      const std::vector<Proof>& past,
                      const std::vector<Proof>& present) {
  const Segment& segment = frame.seg.segments[s];
  const std::uint32_t id = frame.instances[s].id;
  const auto alike = [&](const Proof& proof) { return isSameSize(proof.size, segment.box.size); };
  const bool parked = isParkedHere(frame, s, config_);
  if (!parked && std::count_if(present.begin(), present.end(), alike) >= kProofs) return true;
  if (parked && config_.semi_static != SemiStatic::kRemove) return false;
  std::vector<Proof> proofs = past;
  proofs.insert(proofs.end(), present.begin(), present.end());
  forgetOthers(id, proofs);
  if (secondsOfMotion(proofs, segment, parked) < kStrongSeconds ||
      !wentAway(proofs, proofOf(frame, s))) {
    return false;
  }
  const bool apart = standsApart(frame, s, proofs, config_);
  if (apart && parked) {
    ++past_[id].apart;
    past_[id].last_apart = frame.index;
  }
  return !apart && !(parked && staysBehind(frame, s, proofs, config_));
}

void TrackBook::forgetOthers(std::uint32_t id, std::vector<Proof>& proofs) const {
  const auto past = past_.find(id);
  if (past == past_.end() || past->second.apart < kOftenApart) return;
  const auto others = std::remove_if(proofs.begin(), proofs.end(), [&](const Proof& proof) {
    return proof.scan <= past->second.last_apart;
  });
  proofs.erase(others, proofs.end());
}

std::vector<Proof> TrackBook::pastOf(std::uint32_t id, const KeyFrame& first) const {
  const auto past = past_.find(id);
  if (past == past_.end()) return {};
  const std::vector<Proof>& proofs = past->second.proofs;
  return {proofs.begin(),
          std::lower_bound(proofs.begin(), proofs.end(), first.index,
                           [](const Proof& proof, std::size_t scan) { return proof.scan < scan; })};
}

void TrackBook::inherit(const KeyFrame& frame) {
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    if (instance.parent == 0 || past_.count(instance.id) != 0) continue;
    past_[instance.id].proofs = pastOf(instance.parent, frame);
  }
}

bool TrackBook::isDynamic(const KeyFrame& frame, std::size_t segment) {
  const std::vector<PairVote>& votes = frame.evidence->votes[segment];
  std::vector<Judgement>& judged = judged_[frame.index];
  judged.resize(frame.evidence->votes.size());
  Judgement& last = judged[segment];
  if (last.votes != votes.size()) {
    const ObjectClass object_class = frame.seg.segments[segment].object_class;
    last = {votes.size(), judgeVotes(votes, object_class, config_).dynamic};
  }
  return last.dynamic;
}

std::map<std::uint32_t, TrackBook::Track> TrackBook::tracksOf(const KeyFrame& frame,
                                                              const Window& window) {
  judged_.erase(judged_.begin(), judged_.lower_bound(window.front()->index));
  const Heirs heirs = heirsOf(frame, window);
  std::map<std::uint32_t, Track> tracks;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) tracks[frame.instances[s].id];
  for (const KeyFrame* other : window) {
    for (std::size_t s = 0; s < other->evidence->votes.size(); ++s) {
      const std::uint32_t id = other->instances[s].id;
      const auto track = tracks.find(id);
      const auto [heir, end] = heirs.equal_range(id);
      if (track != tracks.end()) ++track->second.members;
      if ((track == tracks.end() && heir == end) || !isDynamic(*other, s)) continue;
      const Proof proof = proofOf(*other, s);
      if (track != tracks.end()) track->second.proofs.push_back(proof);
      for (auto it = heir; it != end; ++it) {
        if (other->index < it->second.scan) tracks.at(it->second.id).inherited.push_back(proof);
      }
    }
  }
  return tracks;
}

void TrackBook::propagate(const Window& window, std::size_t position) {
  KeyFrame& frame = *window[position];
  inherit(frame);
  const std::map<std::uint32_t, Track> tracks = tracksOf(frame, window);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    const Track& track = tracks.at(instance.id);
    std::vector<Proof> past = pastOf(instance.id, *window.front());
    past.insert(past.end(), track.inherited.begin(), track.inherited.end());
    if (instance.dynamic && isOutvoted(track.members, track.proofs, past)) {
      instance.dynamic = false;
      instance.reason = Reason::kRestored;
    } else if (!instance.dynamic && moves(frame, s, past, track.proofs)) {
      instance.dynamic = true;
      instance.reason = Reason::kTrack;
    }
  }
}

void TrackBook::note(const KeyFrame& frame) {
  const double now = frame.evidence->time;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    Past& past = past_[instance.id];
    past.seen = now;
    if (!instance.dynamic || instance.reason != Reason::kVotes) continue;
    if (past.proofs.size() == kKeptProofs) past.proofs.erase(past.proofs.begin() + kKeptProofs / 2);
    past.proofs.push_back(proofOf(frame, s));
  }
  for (auto past = past_.begin(); past != past_.end();) {
    const bool kept = std::abs(now - past->second.seen) <= kLongestGap;
    past = kept ? std::next(past) : past_.erase(past);
  }
}

}  // namespace segdf

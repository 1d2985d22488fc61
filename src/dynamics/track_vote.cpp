// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/track_vote.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/instance_links.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr int kProofs = 2;
constexpr std::size_t kKeptProofs = 64;  // of the past: the first half, and the latest
constexpr std::size_t kManyMembers = 8;
constexpr double kFewDynamic = 0.1;  // share of the members
constexpr int kOftenApart = 3;       // instances of an id that stood apart from what moved
constexpr float kHighestCar = 2.2F;  // metres
constexpr double kKeptShare = 0.2;   // of the points
constexpr double kHeirGate = 2.5;    // metres from one scan to the next

/// True when more than a scrap of the frame's instance was found to stand. Parts come after all
/// segments.
bool hasKeptPart(const KeyFrame& frame, std::size_t segment) {
  const std::uint32_t id = frame.instances[segment].id;
  const auto rest = static_cast<double>(frame.seg.segments[segment].points.size());
  for (std::size_t p = frame.evidence->votes.size(); p < frame.instances.size(); ++p) {
    const Instance& part = frame.instances[p];
    if (part.parent != id || part.reason != Reason::kKept) continue;
    const auto points = static_cast<double>(frame.seg.segments[p].points.size());
    if (points >= kKeptShare * (points + rest)) return true;
  }
  return false;
}

/// True when the votes made the instance dynamic, as one object. When a part of it was found to
/// stand its id may pass on to that: a parked car, next to somebody who went with it for a while.
/// Of a car that creeps an edge seems to stand. Of what is higher than cars, parts stood for a
/// while themselves.
bool provesMotion(const KeyFrame& frame, std::size_t segment) {
  const Instance& instance = frame.instances[segment];
  const bool car_sized = frame.seg.segments[segment].box.size.z() < kHighestCar;
  const bool by_votes = instance.reason == Reason::kVotes || instance.reason == Reason::kDeparture;
  return instance.dynamic && by_votes && !(car_sized && hasKeptPart(frame, segment));
}

/// Merges proofs, one for each scan, and forgets those in the middle when there are too many.
void addProofs(const MotionProofs& more, MotionProofs& proofs) {
  MotionProofs all;
  std::merge(proofs.begin(), proofs.end(), more.begin(), more.end(), std::back_inserter(all),
             [](const MotionProof& a, const MotionProof& b) { return a.scan < b.scan; });
  // What an id has from two that inherited the same counts once.
  all.erase(
      std::unique(all.begin(), all.end(),
                  [](const MotionProof& a, const MotionProof& b) { return a.scan == b.scan; }),
      all.end());
  if (all.size() > kKeptProofs) {
    all.erase(all.begin() + kKeptProofs / 2, all.end() - kKeptProofs / 2);
  }
  proofs = std::move(all);
}

bool isParkedHere(const KeyFrame& frame, std::size_t s, const DynamicConfig& config) {
  return isParked(frame.evidence->votes[s], frame.seg.segments[s].points.size(), config);
}

/// True when what can move came during the drive, and nobody saw it do so.
bool cameToStand(const KeyFrame& frame, std::size_t s, const DynamicConfig& config) {
  const Segment& segment = frame.seg.segments[s];
  return config.semi_static == SemiStatic::kRemove && isTested(segment.object_class) &&
         isMoverSized(segment.box.size) &&
         cameHere(frame.evidence->votes[s], segment.points.size(), config);
}

/// True when hardly any member of the track moved, of many. A car that came and stopped is seen
/// through from before it came for seconds, and so are many of its members.
bool isOutvoted(std::size_t dynamic, std::size_t members) {
  return members >= kManyMembers &&
         static_cast<double>(dynamic) < kFewDynamic * static_cast<double>(members);
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
                      MotionProofs proofs,
                      const MotionProofs& present,
                      const Window& window) {
  const Segment& segment = frame.seg.segments[s];
  const std::uint32_t id = frame.instances[s].id;
  const auto alike = [&](const MotionProof& proof) {
    return isSameSize(proof.size, segment.box.size);
  };
  const bool parked = isParkedHere(frame, s, config_);
  if (!parked && std::count_if(present.begin(), present.end(), alike) >= kProofs) return true;
  if (parked && config_.semi_static != SemiStatic::kRemove) return false;
  forgetOthers(id, proofs);
  if (secondsOfMotion(proofs, segment, parked) < kStrongSeconds) return false;
  const MotionProofs own = ownProofs(frame, s, proofs, parked, window);
  return secondsOfMotion(own, segment, parked) >= kStrongSeconds &&
         !(parked && staysBehind(frame, s, own, config_));
}

MotionProofs TrackBook::ownProofs(const KeyFrame& frame,
                                  std::size_t s,
                                  const MotionProofs& proofs,
                                  bool parked,
                                  const Window& window) {
  Past& past = past_.at(frame.instances[s].id);
  const MotionProofs views = viewsOf(frame.instances[s].id, window);
  MotionProofs own;
  for (const Side side : {Side::kBefore, Side::kAfter}) {
    const MotionProofs some = proofsOn(side, frame.index, proofs);
    if (some.empty()) continue;
    if (!standsApart(frame, s, side, some, views, config_)) {
      own.insert(own.end(), some.begin(), some.end());
    } else if (parked && side == Side::kBefore) {
      ++past.apart;
      past.last_apart = frame.index;
    }
  }
  return own;
}

MotionProofs TrackBook::viewsOf(std::uint32_t id, const Window& window) const {
  MotionProofs views = past_.at(id).views;
  for (const KeyFrame* frame : window) {
    for (std::size_t s = 0; s < frame->evidence->votes.size(); ++s) {
      if (frame->instances[s].id == id) views.push_back(proofOf(*frame, s));
    }
  }
  return views;
}

void TrackBook::forgetOthers(std::uint32_t id, MotionProofs& proofs) const {
  const Past& past = past_.at(id);
  if (past.apart < kOftenApart) return;
  const auto others = std::remove_if(proofs.begin(), proofs.end(), [&](const MotionProof& proof) {
    return proof.scan <= past.last_apart;
  });
  proofs.erase(others, proofs.end());
}

MotionProofs TrackBook::pastOf(std::uint32_t id, const KeyFrame& first) const {
  const auto past = past_.find(id);
  if (past == past_.end()) return {};
  return proofsOn(Side::kBefore, first.index, past->second.proofs);
}

void TrackBook::inherit(const KeyFrame& frame) {
  std::set<std::uint32_t> here;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    here.insert(instance.id);
    const auto [past, born] = past_.try_emplace(instance.id);
    if (!born) continue;
    const auto parent = past_.find(instance.parent);
    if (parent != past_.end()) {
      past->second = parent->second;
      past->second.proofs = pastOf(instance.parent, frame);
      past->second.moved = false;
      past->second.stood = false;
    }
    past->second.born = frame.index;
    past->second.born_at = frame.evidence->time;
  }
  for (auto& [id, past] : past_) {
    if (!past.moved || here.count(id) != 0) continue;
    const std::uint32_t heir = heirOf(past, frame);
    if (heir == 0) continue;
    addProofs(past.proofs, past_.at(heir).proofs);
    past.moved = false;
  }
}

std::uint32_t TrackBook::heirOf(const Past& ended, const KeyFrame& frame) {
  std::uint32_t heir = 0;
  double least = kHeirGate;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const std::uint32_t id = frame.instances[s].id;
    const Past& other = past_.at(id);
    const bool beside = other.born_at < ended.seen - kLongestGap;
    if (beside || other.stood || other.born <= ended.proofs.front().scan) continue;
    if (!isDynamic(frame, s)) continue;
    const Eigen::Vector3d way = proofOf(frame, s).center - ended.proofs.back().center;
    const double distance = way.head<2>().norm();
    if (distance >= least) continue;
    least = distance;
    heir = id;
  }
  return heir;
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

std::unordered_map<std::uint32_t, TrackBook::Track> TrackBook::tracksOf(const KeyFrame& frame,
                                                                        const Window& window) {
  judged_.erase(judged_.begin(), judged_.lower_bound(window.front()->index));
  const Heirs heirs = heirsOf(frame, window);
  std::unordered_map<std::uint32_t, Track> tracks;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) tracks[frame.instances[s].id];
  for (const KeyFrame* other : window) {
    for (std::size_t s = 0; s < other->evidence->votes.size(); ++s) {
      const std::uint32_t id = other->instances[s].id;
      const auto track = tracks.find(id);
      const auto [heir, end] = heirs.equal_range(id);
      if (track != tracks.end()) ++track->second.members;
      if ((track == tracks.end() && heir == end) || !isDynamic(*other, s)) continue;
      const MotionProof proof = proofOf(*other, s);
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
  const std::unordered_map<std::uint32_t, Track> tracks = tracksOf(frame, window);
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    Instance& instance = frame.instances[s];
    const Track& track = tracks.at(instance.id);
    MotionProofs proofs = pastOf(instance.id, *window.front());
    proofs.insert(proofs.end(), track.inherited.begin(), track.inherited.end());
    const std::size_t members = proofs.size() + track.members;
    proofs.insert(proofs.end(), track.proofs.begin(), track.proofs.end());
    if (instance.dynamic && isOutvoted(proofs.size(), members)) {
      instance.dynamic = false;
      instance.reason = Reason::kRestored;
    } else if (!instance.dynamic && moves(frame, s, proofs, track.proofs, window)) {
      instance.dynamic = true;
      instance.reason = Reason::kTrack;
    } else if (!instance.dynamic && cameToStand(frame, s, config_)) {
      instance.dynamic = true;
      instance.reason = Reason::kLongLook;
    }
    if (instance.dynamic) {
      instance.whole = movedAsAWhole(proofs, proofOf(frame, s));
    }
  }
}

void TrackBook::note(const KeyFrame& frame) {
  const double now = frame.evidence->time;
  for (std::size_t s = 0; s < frame.evidence->votes.size(); ++s) {
    const Instance& instance = frame.instances[s];
    Past& past = past_[instance.id];
    past.seen = now;
    past.moved = provesMotion(frame, s);
    past.stood = past.stood || (!instance.dynamic && isParkedHere(frame, s, config_));
    const MotionProof view = proofOf(frame, s);
    past.views.push_back(view);
    if (past.views.size() > static_cast<std::size_t>(config_.window)) {
      past.views.erase(past.views.begin());
    }
    if (past.moved) addProofs({view}, past.proofs);
  }
  for (auto past = past_.begin(); past != past_.end();) {
    const bool kept = std::abs(now - past->second.seen) <= kLongestGap;
    past = kept ? std::next(past) : past_.erase(past);
  }
}

}  // namespace segdf

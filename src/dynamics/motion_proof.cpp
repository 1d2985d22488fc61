// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/motion_proof.hpp"

#include <algorithm>
#include <cmath>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"

namespace segdf {

namespace {

constexpr double kLongestStep = 0.3;  // seconds that a proof stands for

// Motion elsewhere in scans that found the instance here: three scans at 10 Hz, or two when the
// track had no place in common with it and none saw through it.
constexpr double kElsewhereSeconds = 0.25;
constexpr int kElsewhereScans = 2;
constexpr float kElsewhere = 2.0F;  // metres: farther than views of one car differ
constexpr int kFoundBeyond = 2;     // scans
constexpr double kWhole = 0.9;      // share of the points: all but what was hidden

/// True when a proof may be another view of a thing that stands here. It is not longer; height and
/// width do not count, as what moved at a distance stands beside the sensor now, which sees a part
/// of its side.
bool mayHaveStopped(const Eigen::Vector3f& size, const MotionProof& proof) {
  return proof.size.x() <= greatestView(size).x();
}

/// True when the proof may be one of the segment's object: a part of it, or, where hardly anybody
/// found the segment again, what it is a part of; of what by its class cannot move (a hedge before
/// which somebody walks), what has its size.
bool mayBeOf(const Segment& segment, const MotionProof& proof, bool parked) {
  const Eigen::Vector3f& size = segment.box.size;
  if (!isTested(segment.object_class)) return isSameSize(proof.size, size);
  if (parked) return mayHaveStopped(size, proof);
  return isPartOf(proof.size, size) || isPartOf(size, proof.size);
}

bool isFarther(const MotionProof& a, const MotionProof& b, float distance) {
  return (a.center - b.center).norm() > static_cast<double>(std::max(kElsewhere, distance));
}

/// The track's proofs of motion that are farther from here than views of one object differ.
MotionProofs elsewhere(const MotionProofs& proofs, const MotionProof& here) {
  MotionProofs far;
  for (const MotionProof& proof : proofs) {
    if (isFarther(proof, here, 0.5F * std::max(here.size.x(), proof.size.x()))) {
      far.push_back(proof);
    }
  }
  return far;
}

/// The track's views that have no place in common with this one: of what stands half hidden, a
/// piece at its end is seen at times.
MotionProofs viewsBeside(const MotionProofs& views, const MotionProof& here) {
  MotionProofs beside;
  for (const MotionProof& view : views) {
    if (isFarther(view, here, 0.5F * (here.size.x() + view.size.x()))) beside.push_back(view);
  }
  return beside;
}

/// The view by a scan, or nullptr.
const MotionProof* viewOf(std::size_t scan, const MotionProofs& views) {
  const auto view = std::find_if(views.begin(), views.end(),
                                 [scan](const MotionProof& v) { return v.scan == scan; });
  return view == views.end() ? nullptr : &*view;
}

/// True when the track moved elsewhere between the scan of the instance and another.
bool isBetween(const MotionProofs& far, std::size_t scan, std::size_t other) {
  const auto [first, last] = std::minmax(scan, other);
  return std::any_of(far.begin(), far.end(),
                     [first = first, last = last](const MotionProof& proof) {
                       return proof.scan > first && proof.scan < last;
                     });
}

/// True when a scan found the segment again from beyond motion elsewhere. Who brakes is where he
/// will stop with a part of himself, and partial views of him seem to be elsewhere: of what was
/// found in the midst of the motion all must have been here.
bool isFoundBeyond(const PairVote& vote,
                   std::size_t scan,
                   std::size_t points,
                   const MotionProofs& proofs,
                   const MotionProofs& far) {
  if (!isBetween(far, scan, vote.scan)) return false;
  const bool amid = vote.scan >= proofs.front().scan && vote.scan <= proofs.back().scan;
  return !amid || static_cast<double>(vote.hit) >= kWhole * static_cast<double>(points);
}

}  // namespace

MotionProof proofOf(const KeyFrame& frame, std::size_t segment) {
  return {frame.index, frame.seg.segments[segment].box.size, centerOf(frame, segment),
          std::min(frame.evidence->step, kLongestStep)};
}

double secondsOfMotion(const MotionProofs& proofs, const Segment& segment, bool parked) {
  double seconds = 0.0;
  for (const MotionProof& proof : proofs) {
    if (mayBeOf(segment, proof, parked)) seconds += proof.seconds;
  }
  return seconds;
}

bool movedAsAWhole(const MotionProofs& proofs, const MotionProof& here) {
  double seconds = 0.0;
  for (const MotionProof& proof : proofs) {
    const bool away = (proof.center - here.center).norm() > static_cast<double>(kElsewhere);
    if (away && isSameSize(proof.size, here.size)) seconds += proof.seconds;
  }
  return seconds >= kStrongSeconds;
}

MotionProofs proofsOn(Side side, std::size_t scan, const MotionProofs& proofs) {
  const auto middle = std::partition_point(
      proofs.begin(), proofs.end(), [scan](const MotionProof& proof) { return proof.scan < scan; });
  return side == Side::kBefore ? MotionProofs(proofs.begin(), middle)
                               : MotionProofs(middle, proofs.end());
}

bool standsApart(const KeyFrame& frame,
                 std::size_t segment,
                 Side side,
                 const MotionProofs& proofs,
                 const MotionProofs& views,
                 const DynamicConfig& config) {
  const MotionProof here = proofOf(frame, segment);
  const MotionProofs far = elsewhere(proofs, here);
  const MotionProofs beside = viewsBeside(views, here);
  const std::size_t points = frame.seg.segments[segment].points.size();
  double seconds = 0.0;
  int scans = 0;
  int scans_beside = 0;
  int beyond = 0;
  bool seen_through = false;
  for (const PairVote& vote : frame.evidence->votes[segment]) {
    if ((vote.scan < frame.index) != (side == Side::kBefore)) continue;
    seen_through = seen_through || isSeenThrough(vote, config);
    if (!isFoundAgain(vote, points, config)) continue;
    const MotionProof* const view_beside = viewOf(vote.scan, beside);
    const MotionProof* const view = view_beside != nullptr ? view_beside : viewOf(vote.scan, far);
    scans += view != nullptr ? 1 : 0;
    seconds += view != nullptr ? view->seconds : 0.0;
    scans_beside += view_beside != nullptr ? 1 : 0;
    beyond += isFoundBeyond(vote, frame.index, points, proofs, far) ? 1 : 0;
  }
  return (scans >= kElsewhereScans && seconds >= kElsewhereSeconds) ||
         (!seen_through && (scans_beside >= kElsewhereScans || beyond >= kFoundBeyond));
}

bool staysBehind(const KeyFrame& frame,
                 std::size_t segment,
                 const MotionProofs& proofs,
                 const DynamicConfig& config) {
  const std::size_t first = proofs.front().scan;
  const std::vector<PairVote>& votes = frame.evidence->votes[segment];
  return first > frame.index && std::none_of(votes.begin(), votes.end(), [&](const PairVote& vote) {
           return vote.scan >= first && isSeenThrough(vote, config);
         });
}

}  // namespace segdf

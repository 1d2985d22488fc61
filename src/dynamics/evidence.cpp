// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/evidence.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "segdf/classification/classifier.hpp"
#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

constexpr std::size_t kLarge = 300;       // points, of what cannot move
constexpr std::size_t kVeryLarge = 1000;  // points, of what can: people and most cars have fewer
constexpr double kJitter = 0.05;          // seconds

// Places side by side of which every kStride-th is looked at first: a part that moved has several
// of these from df.split_min on.
constexpr std::uint32_t kBlock = 64;
constexpr std::uint32_t kStride = 4;
constexpr std::uint32_t kEnoughPlaces = 32;  // of a segment, for some to speak for all
constexpr std::uint32_t kMany = 256;         // the same, for what it touches in the next key frame

/// One place for each voxel is enough.
bool isCoarse(const Segment& segment) {
  return segment.points.size() > (isTested(segment.object_class) ? kVeryLarge : kLarge);
}

/// Voxels by segment, those of no segment last: [begin[s], begin[s + 1]) of the list.
std::vector<std::uint32_t> voxelsBySegment(const KeyFrame& frame,
                                           std::vector<std::uint32_t>& begin) {
  const std::size_t segments = frame.seg.segments.size();
  const std::vector<std::int32_t>& clusters = frame.seg.clusters.of_voxel;
  const auto group_of = [&](std::size_t v) {
    return clusters[v] == Clusters::kNoise ? segments : static_cast<std::size_t>(clusters[v]);
  };
  begin.assign(segments + 2, 0);
  for (std::size_t v = 0; v < clusters.size(); ++v) ++begin[group_of(v) + 1];
  for (std::size_t g = 0; g <= segments; ++g) begin[g + 1] += begin[g];
  std::vector<std::uint32_t> next = begin;
  std::vector<std::uint32_t> order(clusters.size());
  for (std::size_t v = 0; v < clusters.size(); ++v) {
    order[next[group_of(v)]++] = static_cast<std::uint32_t>(v);
  }
  return order;
}

/// Adds one voxel: as one place, or as one for each of its points. @param places the points that
/// stand for places
void addVoxel(const CurvedVoxels& voxels,
              std::uint32_t v,
              bool whole,
              std::vector<std::uint32_t>& places,
              FrameEvidence& evidence) {
  const auto place = [&](std::uint32_t point) {
    places.push_back(point);
    evidence.first.push_back(static_cast<std::uint32_t>(evidence.listed.size()));
  };
  if (whole) place(voxels.points[(voxels.begin[v] + voxels.begin[v + 1]) / 2]);
  for (std::uint32_t k = voxels.begin[v]; k < voxels.begin[v + 1]; ++k) {
    if (!whole) place(voxels.points[k]);
    evidence.listed.push_back(voxels.points[k]);
  }
}

using Places = Eigen::Ref<const Eigen::MatrixX3f>;

using States = std::array<VolumetricState, kBlock>;

/// States of up to kBlock places. @return false when none is FREE
/// @param some every kStride-th is looked at, and all of them only when one of these is seen
/// through; else they are what the one before them is. Most of a scan stands.
bool lookAt(const VisibilityImage& image,
            const Places& places,
            bool some,
            const Eigen::Isometry3f& image_T_places,
            States& states) {
  if (some) {
    constexpr Eigen::Index kMost = kBlock / kStride;
    const Eigen::Index count = (places.rows() + kStride - 1) / kStride;
    Eigen::Matrix<float, Eigen::Dynamic, 3, 0, kMost, 3> sample(count, 3);
    for (Eigen::Index k = 0; k < count; ++k) sample.row(k) = places.row(k * kStride);
    std::array<VolumetricState, kMost> seen{};
    image.look(sample, image_T_places, seen.data());
    for (std::size_t k = 0; k < kMost; ++k) {
      std::fill_n(states.begin() + k * kStride, kStride, seen[k]);
    }
    if (std::find(seen.begin(), seen.end(), VolumetricState::kFree) == seen.end()) return false;
  }
  image.look(places, image_T_places, states.data());
  return true;
}

/// Counts the answers `wanted` of so many places. @return points that these stand for
/// @param first of each place, its first point, and one more
std::uint32_t countAnswers(const States& states,
                           std::size_t places,
                           VolumetricState wanted,
                           const std::uint32_t* first,
                           std::uint8_t* counters) {
  std::uint32_t points = 0;
  for (std::size_t k = 0; k < places; ++k) {
    const unsigned counts = states[k] == wanted ? 1 : 0;
    const unsigned room = counters[k] < std::numeric_limits<std::uint8_t>::max() ? 1 : 0;
    // Without a branch: nobody can foretell answers.
    counters[k] = static_cast<std::uint8_t>(counters[k] + (counts & room));
    points += counts * (first[k + 1] - first[k]);
  }
  return points;
}

Eigen::MatrixX3f positionsOf(const std::vector<std::uint32_t>& points, const Scan& scan) {
  Eigen::MatrixX3f positions(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    positions.row(static_cast<Eigen::Index>(k)) = scan.points[points[k]].position();
  }
  return positions;
}

}  // namespace

bool isFarInTime(double seconds, const DynamicConfig& config) {
  return std::abs(seconds) >= config.keep_delay - kJitter;
}

FrameEvidence prepareEvidence(const KeyFrame& frame, const DynamicConfig& config) {
  const std::vector<Point>& points = frame.scan.points;
  return {frame.scan.stampSeconds(),
          0.0,
          0.0,
          VisibilityImage(points, frame.seg.roles, config),
          PlaneMap(points, frame.seg.roles),
          thinForRegistration(points, frame.seg.roles),
          {},
          {},
          {},
          {},
          {},
          {},
          {}};
}

void listPlaces(KeyFrame& frame) {
  FrameEvidence& evidence = *frame.evidence;
  std::vector<std::uint32_t> begin;
  const std::vector<std::uint32_t> order = voxelsBySegment(frame, begin);
  std::vector<std::uint32_t> places;
  for (std::size_t group = 0; group + 1 < begin.size(); ++group) {
    evidence.begin.push_back(static_cast<std::uint32_t>(places.size()));
    const bool segment = group < frame.seg.segments.size();
    const bool whole = segment && isCoarse(frame.seg.segments[group]);
    for (std::uint32_t k = begin[group]; k < begin[group + 1]; ++k) {
      addVoxel(frame.seg.voxels, order[k], whole, places, evidence);
    }
  }
  evidence.begin.push_back(static_cast<std::uint32_t>(places.size()));
  evidence.first.push_back(static_cast<std::uint32_t>(evidence.listed.size()));
  evidence.places = positionsOf(places, frame.scan);
  evidence.free.resize(places.size());
  evidence.hit.resize(places.size());
  evidence.votes.resize(frame.seg.segments.size());
}

PointsBySegment placePoints(const KeyFrame& frame) {
  const FrameEvidence& evidence = *frame.evidence;
  PointsBySegment result{{0}, {}};
  for (std::size_t s = 0; s + 2 < evidence.begin.size(); ++s) {
    const std::uint32_t count = evidence.begin[s + 1] - evidence.begin[s];
    const std::uint32_t step = count < kMany ? 1 : kStride;
    for (std::uint32_t k = evidence.begin[s]; k < evidence.begin[s + 1]; k += step) {
      result.points.push_back(evidence.listed[evidence.first[k]]);
    }
    result.begin.push_back(static_cast<std::uint32_t>(result.points.size()));
  }
  return result;
}

std::vector<PlaceEvidence> evidenceByPoint(const KeyFrame& frame) {
  const FrameEvidence& evidence = *frame.evidence;
  std::vector<PlaceEvidence> by_point(frame.scan.points.size());
  for (std::size_t k = 0; k < evidence.free.size(); ++k) {
    for (std::uint32_t p = evidence.first[k]; p < evidence.first[k + 1]; ++p) {
      by_point[evidence.listed[p]] = evidence.answer(k);
    }
  }
  return by_point;
}

void gatherEvidence(KeyFrame& frame,
                    const KeyFrame& other,
                    const Pose& other_T_frame,
                    const DynamicConfig& config,
                    int threads) {
  FrameEvidence& evidence = *frame.evidence;
  const VisibilityImage& image = other.evidence->image;
  const Eigen::Isometry3f image_T_frame = other_T_frame.cast<float>();
  const double seconds = other.evidence->time - evidence.time;
  const bool late = isFarInTime(seconds, config);
  const std::size_t loose = evidence.votes.size();
  const auto look = [&](std::size_t group) {
    const std::uint32_t end = evidence.begin[group + 1];
    // Places in no segment have nothing to do with each other.
    const bool some = group != loose && end - evidence.begin[group] >= kEnoughPlaces;
    PairVote vote;
    States states{};
    std::array<std::uint8_t, kBlock> early{};  // hits that do not count
    for (std::uint32_t k = evidence.begin[group]; k < end; k += kBlock) {
      const std::uint32_t count = std::min(kBlock, end - k);
      const Places places = evidence.places.middleRows(k, count);
      const bool any_free = lookAt(image, places, some, image_T_frame, states);
      const std::uint32_t* first = evidence.first.data() + k;
      if (any_free) {
        vote.free +=
            countAnswers(states, count, VolumetricState::kFree, first, evidence.free.data() + k);
      }
      vote.hit += countAnswers(states, count, VolumetricState::kHit, first,
                               late ? evidence.hit.data() + k : early.data());
    }
    return vote;
  };
  parallelFor(loose + 1, threads, [&](std::size_t group) {
    PairVote vote = look(group);
    if (group == loose || vote.free + vote.hit == 0) return;
    vote.scan = other.index;
    vote.seconds = static_cast<float>(seconds);
    const auto points = static_cast<double>(frame.seg.segments[group].points.size());
    const double least = std::max<double>(config.vis_min, config.vis_frac * points);
    vote.informative = static_cast<double>(vote.free + vote.hit) >= least;
    evidence.votes[group].push_back(vote);
  });
}

}  // namespace segdf

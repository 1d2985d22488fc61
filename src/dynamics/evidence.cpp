// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/evidence.hpp"

#include <algorithm>
#include <limits>

#include "segdf/classification/classifier.hpp"
#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

constexpr std::size_t kLarge = 300;  // points
constexpr double kJitter = 0.05;     // seconds

// Of the places of a segment every so many-th is looked for first.
constexpr std::uint32_t kStride = 4;
constexpr std::uint32_t kWideStride = 8;
constexpr std::uint32_t kMany = 24;       // places, from which on there is a sample
constexpr std::uint32_t kVeryMany = 512;  // from which on the stride is wide
constexpr std::ptrdiff_t kFewFree = 33;   // 1 in so many places of the sample

std::uint32_t strideOf(std::uint32_t count) {
  if (count < kMany) return 1;
  return count < kVeryMany ? kStride : kWideStride;
}

/// How many of a segment's places stand for the others, in a first look.
std::uint32_t sampleOf(std::uint32_t count) {
  const std::uint32_t stride = strideOf(count);
  return (count + stride - 1) / stride;
}

void increment(std::uint8_t& counter) {
  if (counter < std::numeric_limits<std::uint8_t>::max()) ++counter;
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

/// A place, and the points that it stands for: [begin, end) of the voxels' points.
struct Place {
  std::uint32_t point = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Adds one voxel: as one place, or as one for each of its points.
void addVoxel(const CurvedVoxels& voxels, std::uint32_t v, bool whole, std::vector<Place>& places) {
  const std::uint32_t begin = voxels.begin[v];
  const std::uint32_t end = voxels.begin[v + 1];
  if (whole) {
    places.push_back({voxels.points[(begin + end) / 2], begin, end});
    return;
  }
  for (std::uint32_t k = begin; k < end; ++k) places.push_back({voxels.points[k], k, k + 1});
}

/// The sample of a segment's places first, then the others, in their order.
std::vector<Place> sampleFirst(const std::vector<Place>& places) {
  const auto count = static_cast<std::uint32_t>(places.size());
  if (sampleOf(count) == count) return places;
  std::vector<Place> ordered;
  ordered.reserve(count);
  const std::uint32_t stride = strideOf(count);
  for (std::uint32_t k = 0; k < count; k += stride) ordered.push_back(places[k]);
  for (std::uint32_t k = 0; k < count; ++k) {
    if (k % stride != 0) ordered.push_back(places[k]);
  }
  return ordered;
}

/// States of a segment's places in the image of another key frame. Most of what stands is settled
/// by a look at a quarter of it: where the sample sees through hardly any, only the places beside
/// these are looked for, too, and the others are taken for what the sample is.
std::vector<VolumetricState> lookFor(const Eigen::Ref<const Eigen::MatrixX3f>& places,
                                     std::uint32_t sample,
                                     const VisibilityImage& image,
                                     const Eigen::Isometry3f& image_T_places) {
  const auto count = static_cast<std::uint32_t>(places.rows());
  std::vector<VolumetricState> states(count);
  image.look(places.topRows(sample), image_T_places, states.data());
  if (sample == count) return states;
  const auto free = std::count(states.begin(), states.begin() + sample, VolumetricState::kFree);
  if (kFewFree * free > sample) {
    image.look(places.bottomRows(count - sample), image_T_places, states.data() + sample);
    return states;
  }
  const std::uint32_t beside = strideOf(count) - 1;
  for (std::uint32_t k = 0; k < sample; ++k) {
    const std::uint32_t begin = std::min(count, sample + beside * k);
    const std::uint32_t end = std::min(count, begin + beside);
    if (states[k] == VolumetricState::kFree) {
      image.look(places.middleRows(begin, end - begin), image_T_places, states.data() + begin);
    } else {
      std::fill(states.begin() + begin, states.begin() + end, states[k]);
    }
  }
  return states;
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
          {}};
}

void listPlaces(KeyFrame& frame) {
  FrameEvidence& evidence = *frame.evidence;
  std::vector<std::uint32_t> begin;
  const std::vector<std::uint32_t> order = voxelsBySegment(frame, begin);
  std::vector<std::uint32_t> points;
  std::vector<Place> places;
  for (std::size_t group = 0; group + 1 < begin.size(); ++group) {
    evidence.begin.push_back(static_cast<std::uint32_t>(points.size()));
    const bool segment = group < frame.seg.segments.size();
    const bool whole = segment && frame.seg.segments[group].points.size() > kLarge &&
                       !isTested(frame.seg.segments[group].object_class);
    places.clear();
    for (std::uint32_t k = begin[group]; k < begin[group + 1]; ++k) {
      addVoxel(frame.seg.voxels, order[k], whole, places);
    }
    for (const Place& place : segment ? sampleFirst(places) : places) {
      points.push_back(place.point);
      evidence.first.push_back(static_cast<std::uint32_t>(evidence.listed.size()));
      const std::vector<std::uint32_t>& all = frame.seg.voxels.points;
      evidence.listed.insert(evidence.listed.end(), all.begin() + place.begin,
                             all.begin() + place.end);
    }
  }
  evidence.begin.push_back(static_cast<std::uint32_t>(points.size()));
  evidence.first.push_back(static_cast<std::uint32_t>(evidence.listed.size()));
  evidence.places = positionsOf(points, frame.scan);
  evidence.answers.resize(points.size());
  evidence.votes.resize(frame.seg.segments.size());
}

PointsBySegment placePoints(const KeyFrame& frame) {
  const FrameEvidence& evidence = *frame.evidence;
  PointsBySegment result{{evidence.begin.begin(), evidence.begin.end() - 1}, {}};
  for (std::uint32_t k = 0; k < result.begin.back(); ++k) {
    result.points.push_back(evidence.listed[evidence.first[k]]);
  }
  return result;
}

std::vector<PlaceEvidence> evidenceByPoint(const KeyFrame& frame) {
  const FrameEvidence& evidence = *frame.evidence;
  std::vector<PlaceEvidence> by_point(frame.scan.points.size());
  for (std::size_t k = 0; k < evidence.answers.size(); ++k) {
    for (std::uint32_t p = evidence.first[k]; p < evidence.first[k + 1]; ++p) {
      by_point[evidence.listed[p]] = evidence.answers[k];
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
  const Eigen::Isometry3f image_T_frame = other_T_frame.cast<float>();
  const double seconds = other.evidence->time - evidence.time;
  const bool late = isFarInTime(seconds, config);
  const auto look = [&](std::size_t group) {
    PairVote vote;
    vote.scan = other.index;
    vote.seconds = static_cast<float>(seconds);
    const std::uint32_t begin = evidence.begin[group];
    const std::uint32_t end = evidence.begin[group + 1];
    const std::uint32_t sample =
        group == evidence.votes.size() ? end - begin : sampleOf(end - begin);
    const std::vector<VolumetricState> states =
        lookFor(evidence.places.middleRows(begin, end - begin), sample, other.evidence->image,
                image_T_frame);
    for (std::uint32_t k = begin; k < end; ++k) {
      const VolumetricState state = states[k - begin];
      const std::uint32_t points = evidence.first[k + 1] - evidence.first[k];
      if (state == VolumetricState::kFree) {
        increment(evidence.answers[k].free);
        vote.free += points;
      } else if (state == VolumetricState::kHit) {
        if (late) increment(evidence.answers[k].hit);
        vote.hit += points;
      }
    }
    return vote;
  };
  parallelFor(evidence.begin.size() - 1, threads, [&](std::size_t group) {
    PairVote vote = look(group);
    if (group == evidence.votes.size() || vote.free + vote.hit == 0) return;
    const auto points = static_cast<double>(frame.seg.segments[group].points.size());
    const double least = std::max<double>(config.vis_min, config.vis_frac * points);
    vote.informative = static_cast<double>(vote.free + vote.hit) >= least;
    evidence.votes[group].push_back(vote);
  });
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/instance_links.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/dynamics/verdict.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

constexpr double kMotionGate = 2.5;       // metres from where an instance is expected
constexpr double kMovedGate = 1.0;        // the same for what looks otherwise than before
constexpr double kVelocityTime = 0.5;     // seconds: the baseline of a velocity
constexpr double kPartMargin = 0.3;       // metres
constexpr double kPartShare = 1.0 / 3.0;  // of the voxels of what it came off
constexpr double kYoung = 0.5;            // seconds
constexpr double kComparable = 0.6;       // of the voxels of the best link

/// Segments of `to` that instance `s` of `from` makes one; fewer than two when it fuses nothing.
std::vector<std::uint32_t> fusionOf(const KeyFrame& from,
                                    std::size_t s,
                                    const KeyFrame& to,
                                    const SegmentOverlap& overlap,
                                    const Config& config) {
  const ObjectClass object_class = from.seg.segments[s].object_class;
  if (!isTested(object_class) || overlap.occupancy() < config.df.thre_occu) return {};
  std::vector<std::uint32_t> parts;
  Eigen::AlignedBox3f bounds;
  for (const Neighbour& neighbour : overlap.neighbours) {
    const auto index = static_cast<std::uint32_t>(neighbour.segment);
    const Segment& candidate = to.seg.segments[index];
    if (candidate.object_class != object_class || overlap.overlap(neighbour) < config.df.assoc) {
      continue;
    }
    parts.push_back(index);
    bounds.extend(candidate.bounds);
  }
  if (parts.size() < 2 || !fitsMovableObject(bounds, config.cvi)) return {};
  return parts;
}

/// Neighbours under their new numbers. A voxel that touched two parts of one group is counted
/// twice, so the sum is limited to all voxels.
void renumber(const std::vector<std::uint32_t>& groups, SegmentOverlap& overlap) {
  std::vector<Neighbour> renumbered;
  for (Neighbour neighbour : overlap.neighbours) {
    neighbour.segment =
        static_cast<std::int32_t>(groups[static_cast<std::size_t>(neighbour.segment)]);
    const auto same = std::find_if(renumbered.begin(), renumbered.end(), [&](const Neighbour& n) {
      return n.segment == neighbour.segment;
    });
    if (same == renumbered.end()) {
      renumbered.push_back(neighbour);
    } else {
      same->voxels = std::min(same->voxels + neighbour.voxels, overlap.voxels);
    }
  }
  std::sort(renumbered.begin(), renumbered.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.segment < b.segment; });
  overlap.neighbours = std::move(renumbered);
}

struct Link {
  std::uint32_t voxels = 0;
  std::uint32_t id = 0;
  std::uint32_t segment = 0;  ///< of the later frame
  std::uint32_t from = 0;     ///< segment of the earlier frame

  bool operator<(const Link& other) const {
    return std::tie(other.voxels, id, segment) < std::tie(voxels, other.id, other.segment);
  }
};

std::vector<Link> linksOf(const KeyFrame& from,
                          const std::vector<SegmentOverlap>& overlaps,
                          double least) {
  std::vector<Link> links;
  for (std::size_t s = 0; s < overlaps.size(); ++s) {
    for (const Neighbour& neighbour : overlaps[s].neighbours) {
      if (overlaps[s].overlap(neighbour) < least) continue;
      links.push_back({neighbour.voxels, from.instances[s].id,
                       static_cast<std::uint32_t>(neighbour.segment),
                       static_cast<std::uint32_t>(s)});
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

double secondsBetween(const KeyFrame& from, const KeyFrame& to) {
  return to.scan.stampSeconds() - from.scan.stampSeconds();
}

/// True when another key frame saw through the segment.
bool sawThrough(const KeyFrame& other,
                const KeyFrame& frame,
                std::size_t segment,
                const DynamicConfig& config) {
  if (!frame.evidence) return false;
  const std::vector<PairVote>& votes = frame.evidence->votes[segment];
  return std::any_of(votes.begin(), votes.end(), [&](const PairVote& vote) {
    return vote.scan == other.index && isSeenThrough(vote, config);
  });
}

/// How far from where it is expected an instance may be taken for a segment, metres; negative:
/// these are not two views of one object that can move. A car shows more of itself as one draws
/// nearer, and of a far one a line or two are seen, high up or low: what does not look alike must
/// be where its motion so far leads, and so must what was lost for a while; or one key frame must
/// have seen through the other's place: then one left, or the other came.
double gateOf(const KeyFrame& from,
              std::size_t f,
              const KeyFrame& to,
              std::size_t t,
              bool lost,
              const DynamicConfig& config) {
  const Eigen::Vector3f& a = from.seg.segments[f].box.size;
  const Eigen::Vector3f& b = to.seg.segments[t].box.size;
  if (!isMoverSized(a) || !isMoverSized(b)) return -1.0;
  if (isSameSize(a, b)) return lost ? kMovedGate : kMotionGate;
  if (!lost && (sawThrough(to, from, f, config) || sawThrough(from, to, t, config))) {
    return kMotionGate;
  }
  return from.instances[f].velocity.norm() > 0.0 ? kMovedGate : -1.0;
}

/// The highest id of the key frames before the last one: higher ones in the last are young, less
/// than half a second old in `to`. Where key frames are farther apart none are.
std::uint32_t highestOldId(const Window& before, const KeyFrame& to) {
  if (before.size() < 2 || secondsBetween(*before[before.size() - 2], to) > kYoung) {
    return std::numeric_limits<std::uint32_t>::max();
  }
  std::uint32_t highest = 0;
  for (auto frame = before.begin(); frame != before.end() - 1; ++frame) {
    for (const Instance& instance : (*frame)->instances) highest = std::max(highest, instance.id);
  }
  return highest;
}

/// The link to follow in place of links[k]: where that has a young id, of the others to its segment
/// with not many voxels fewer the one with the oldest. Of a far car the front is a segment of its
/// own in one key frame, and in the next one with the rest, of which it has more.
Link elder(const std::vector<Link>& links,
           std::size_t k,
           std::uint32_t highest_old,
           const std::set<std::uint32_t>& given) {
  Link best = links[k];
  if (best.id <= highest_old) return best;
  const double least = kComparable * best.voxels;
  for (; k < links.size() && links[k].voxels >= least; ++k) {
    const Link& link = links[k];
    const bool is_old = link.id <= highest_old && link.id < best.id;
    if (link.segment == best.segment && is_old && given.count(link.id) == 0) best = link;
  }
  return best;
}

struct MotionLink {
  double distance = 0.0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;

  bool operator<(const MotionLink& other) const {
    return std::tie(distance, from, to) < std::tie(other.distance, other.from, other.to);
  }
};

/// Links of segments without a link so far, by predicted place. Things move along the ground: the
/// height of the centre says which lasers hit them.
/// @param lost the instances of `from` were not seen since
std::vector<MotionLink> motionLinks(const KeyFrame& from,
                                    const KeyFrame& to,
                                    const std::set<std::uint32_t>& given,
                                    bool lost,
                                    const DynamicConfig& config) {
  const double dt = secondsBetween(from, to);
  std::vector<MotionLink> links;
  for (std::uint32_t f = 0; f < from.instances.size(); ++f) {
    if (given.count(from.instances[f].id) != 0) continue;
    const Eigen::Vector3d predicted = centerOf(from, f) + dt * from.instances[f].velocity;
    for (std::uint32_t t = 0; t < to.instances.size(); ++t) {
      if (to.instances[t].id != 0) continue;
      const double distance = (centerOf(to, t) - predicted).head<2>().norm();
      if (distance > kMotionGate) continue;
      if (distance <= gateOf(from, f, to, t, lost, config)) links.push_back({distance, f, t});
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

/// From where each instance was half a second ago, or as long as it is known, or in the key frame
/// before: of far things a single step tells little.
void measureVelocities(const Window& before, KeyFrame& to) {
  std::map<std::uint32_t, std::size_t> segment_of;
  for (std::size_t t = 0; t < to.instances.size(); ++t) segment_of.emplace(to.instances[t].id, t);
  for (auto from = before.rbegin(); from != before.rend(); ++from) {
    const double dt = secondsBetween(**from, to);
    if (dt <= 0.0 || (dt > kVelocityTime && from != before.rbegin())) break;
    for (std::size_t f = 0; f < (*from)->instances.size(); ++f) {
      const auto now = segment_of.find((*from)->instances[f].id);
      if (now == segment_of.end()) continue;
      const std::size_t t = now->second;
      to.instances[t].velocity = (centerOf(to, t) - centerOf(**from, f)) / dt;
    }
  }
}

/// A segment's points from above, in the map.
Eigen::AlignedBox2d areaOf(const KeyFrame& frame, std::size_t segment) {
  Eigen::AlignedBox2d area;
  for (std::uint32_t i : frame.seg.segments[segment].points) {
    const Eigen::Vector3d x = frame.scan.pose * frame.scan.points[i].position().cast<double>();
    area.extend(x.head<2>());
  }
  return area;
}

/// True when the segment of `to` lies within where that of `from` was and went to: between both
/// when it brakes. Of what takes a good share of it the centre must: a far car shows now more of
/// its front, now of its rear.
bool isPartHere(
    const KeyFrame& from, std::size_t f, const KeyFrame& to, std::size_t t, double share) {
  const Eigen::Vector3d way = secondsBetween(from, to) * from.instances[f].velocity;
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kPartMargin);
  const Eigen::AlignedBox2d before = areaOf(from, f);
  const Eigen::AlignedBox2d area = before.merged(before.translated(way.head<2>()));
  const Eigen::AlignedBox2d whole(area.min() - margin, area.max() + margin);
  return whole.contains(areaOf(to, t)) ||
         (share >= kPartShare && whole.contains(centerOf(to, t).head<2>()));
}

/// Names for each segment that no link reached the instance that it was a part of.
void findParents(const KeyFrame& from, const std::vector<SegmentOverlap>& overlaps, KeyFrame& to) {
  std::vector<std::uint32_t> most(to.instances.size(), 0);
  for (std::size_t f = 0; f < overlaps.size(); ++f) {
    for (const Neighbour& neighbour : overlaps[f].neighbours) {
      const auto t = static_cast<std::size_t>(neighbour.segment);
      if (to.instances[t].id != 0 || neighbour.voxels <= most[t]) continue;
      if (!isPartHere(from, f, to, t, overlaps[f].overlap(neighbour))) continue;
      most[t] = neighbour.voxels;
      to.instances[t].parent = from.instances[f].id;
    }
  }
}

}  // namespace

void fuseSegments(const KeyFrame& from,
                  KeyFrame& to,
                  const Config& config,
                  std::vector<SegmentOverlap>& overlaps) {
  UnionFind united(to.seg.segments.size());
  bool any = false;
  for (std::size_t s = 0; s < overlaps.size(); ++s) {
    const std::vector<std::uint32_t> parts = fusionOf(from, s, to, overlaps[s], config);
    for (std::size_t k = 1; k < parts.size(); ++k) united.unite(parts[0], parts[k]);
    any = any || parts.size() > 1;
  }
  if (!any) return;
  std::vector<std::uint32_t> groups(to.seg.segments.size());
  std::uint32_t count = 0;
  for (std::uint32_t s = 0; s < groups.size(); ++s) {
    const std::uint32_t root = united.find(s);
    groups[s] = root == s ? count++ : groups[root];
  }
  uniteSegments(to, groups, count, config.classes);
  for (SegmentOverlap& overlap : overlaps) renumber(groups, overlap);
}

void passOnIds(const Window& before,
               KeyFrame& to,
               const std::vector<SegmentOverlap>& overlaps,
               const DynamicConfig& config,
               IdSource& ids) {
  std::set<std::uint32_t> given;
  const auto give = [&](const Instance& from, Instance& instance) {
    if (instance.id == 0 && given.insert(from.id).second) instance.id = from.id;
  };
  const KeyFrame& last = *before.back();
  const std::vector<Link> links = linksOf(last, overlaps, config.assoc);
  const std::uint32_t highest_old = highestOldId(before, to);
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (given.count(links[k].id) != 0 || to.instances[links[k].segment].id != 0) continue;
    const Link link = elder(links, k, highest_old, given);
    give(last.instances[link.from], to.instances[link.segment]);
  }
  for (auto from = before.rbegin(); from != before.rend(); ++from) {
    const bool lost = *from != &last;
    if (lost && secondsBetween(**from, to) > kLongestGap) break;
    for (const MotionLink& link : motionLinks(**from, to, given, lost, config)) {
      give((*from)->instances[link.from], to.instances[link.to]);
    }
    for (const Instance& instance : (*from)->instances) given.insert(instance.id);
  }
  findParents(last, overlaps, to);
  for (Instance& instance : to.instances) {
    if (instance.id == 0) instance.id = ids.next();
  }
  measureVelocities(before, to);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/instance_links.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/dynamics/size_match.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

constexpr double kMotionGate = 2.5;  // metres from where an instance is expected
constexpr double kPartGate = 1.0;    // the same for more or less of it than was seen before

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

Eigen::Vector3d centerOf(const KeyFrame& frame, std::size_t segment) {
  return frame.scan.pose * frame.seg.segments[segment].box.center.cast<double>();
}

/// How far from where it is expected an instance may be taken for a segment, metres; negative:
/// these are not two views of one object that can move. A car shows more of itself as one draws
/// nearer: what is a part of the other must be where its motion so far leads.
double gateOf(const KeyFrame& from, std::size_t f, const KeyFrame& to, std::size_t t) {
  const Eigen::Vector3f& a = from.seg.segments[f].box.size;
  const Eigen::Vector3f& b = to.seg.segments[t].box.size;
  if (!isMoverSized(a) || !isMoverSized(b)) return -1.0;
  if (isSameSize(a, b)) return kMotionGate;
  const bool moved = from.instances[f].velocity.norm() > 0.0;
  return moved && (isPartOf(a, b) || isPartOf(b, a)) ? kPartGate : -1.0;
}

struct MotionLink {
  double distance = 0.0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;

  bool operator<(const MotionLink& other) const {
    return std::tie(distance, from, to) < std::tie(other.distance, other.from, other.to);
  }
};

/// Links of segments without a link so far, by predicted place.
std::vector<MotionLink> motionLinks(const KeyFrame& from,
                                    const KeyFrame& to,
                                    const std::set<std::uint32_t>& given) {
  const double dt = to.scan.stampSeconds() - from.scan.stampSeconds();
  std::vector<MotionLink> links;
  for (std::uint32_t f = 0; f < from.instances.size(); ++f) {
    if (given.count(from.instances[f].id) != 0) continue;
    const Eigen::Vector3d predicted = centerOf(from, f) + dt * from.instances[f].velocity;
    for (std::uint32_t t = 0; t < to.instances.size(); ++t) {
      if (to.instances[t].id != 0) continue;
      const double distance = (centerOf(to, t) - predicted).norm();
      if (distance > kMotionGate) continue;
      if (distance <= gateOf(from, f, to, t)) links.push_back({distance, f, t});
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

void measureVelocity(const KeyFrame& from, std::size_t f, KeyFrame& to, std::size_t t) {
  const double dt = to.scan.stampSeconds() - from.scan.stampSeconds();
  if (dt > 0.0) to.instances[t].velocity = (centerOf(to, t) - centerOf(from, f)) / dt;
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

void passOnIds(const KeyFrame& from,
               KeyFrame& to,
               const std::vector<SegmentOverlap>& overlaps,
               const DynamicConfig& config,
               IdSource& ids) {
  std::set<std::uint32_t> given;
  const auto give = [&](std::uint32_t f, std::uint32_t t) {
    std::uint32_t& id = to.instances[t].id;
    if (id != 0 || !given.insert(from.instances[f].id).second) return;
    id = from.instances[f].id;
    measureVelocity(from, f, to, t);
  };
  for (const Link& link : linksOf(from, overlaps, config.assoc)) give(link.from, link.segment);
  for (const MotionLink& link : motionLinks(from, to, given)) give(link.from, link.to);
  for (Instance& instance : to.instances) {
    if (instance.id == 0) instance.id = ids.next();
  }
}

}  // namespace segdf

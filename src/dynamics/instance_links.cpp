// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/instance_links.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>

#include "segdf/classification/classifier.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/segmentation/clustering.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

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
      links.push_back(
          {neighbour.voxels, from.instances[s].id, static_cast<std::uint32_t>(neighbour.segment)});
    }
  }
  std::sort(links.begin(), links.end());
  return links;
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
  for (const Link& link : linksOf(from, overlaps, config.assoc)) {
    std::uint32_t& id = to.instances[link.segment].id;
    if (id == 0 && given.insert(link.id).second) id = link.id;
  }
  for (Instance& instance : to.instances) {
    if (instance.id == 0) instance.id = ids.next();
  }
}

}  // namespace segdf

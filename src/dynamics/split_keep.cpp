// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/split_keep.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/footprint.hpp"
#include "segdf/dynamics/frame_segments.hpp"
#include "segdf/segmentation/union_find.hpp"

namespace segdf {

namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::uint8_t kFreePairs = 2;  // that make a point moved
constexpr std::uint8_t kFreeRatio = 2;  // more often seen through than found again
constexpr float kMovedMargin = 0.2F;    // metres around what moved
constexpr double kBeside = 0.8;         // share of a part outside of it

bool hasMoved(const PlaceEvidence& e) {
  return e.free >= kFreePairs && e.free >= kFreeRatio * e.hit;
}

/// Connected components of points under the 27-neighbourhood of the curved grid, each ascending,
/// ordered by smallest point index.
std::vector<Indices> connectedParts(const KeyFrame& frame,
                                    const Indices& points,
                                    const CurvedGrid& grid) {
  std::vector<KeyedPoint> items;
  for (std::uint32_t i : points) {
    const auto key = grid.keyOf(frame.scan.points[i].position().cast<double>());
    if (key) items.emplace_back(*key, i);
  }
  const std::vector<float> no_intensity(frame.scan.points.size(), 0.0F);
  const CurvedVoxels voxels = buildCurvedVoxels(std::move(items), no_intensity);
  UnionFind united(voxels.size());
  forEachNeighbour(voxels.keys, voxels, grid, 1, [&](std::size_t q, std::size_t v) {
    if (v > q) united.unite(static_cast<std::uint32_t>(q), static_cast<std::uint32_t>(v));
  });
  std::vector<Indices> by_root(voxels.size());
  for (std::size_t v = 0; v < voxels.size(); ++v) {
    Indices& part = by_root[united.find(static_cast<std::uint32_t>(v))];
    part.insert(part.end(), voxels.points.begin() + voxels.begin[v],
                voxels.points.begin() + voxels.begin[v + 1]);
  }
  by_root.erase(std::remove_if(by_root.begin(), by_root.end(),
                               [](const Indices& part) { return part.empty(); }),
                by_root.end());
  for (Indices& part : by_root) std::sort(part.begin(), part.end());
  std::sort(by_root.begin(), by_root.end());
  return by_root;
}

template <class Wanted>
Indices pointsWhere(const Segment& segment,
                    const std::vector<PlaceEvidence>& by_point,
                    const Wanted& wanted) {
  Indices result;
  for (std::uint32_t i : segment.points) {
    if (wanted(by_point[i])) result.push_back(i);
  }
  return result;
}

/// Makes `part` an instance of its own with the verdict opposite to the one it comes from.
void separate(KeyFrame& frame, std::size_t segment, const Indices& part, IdSource& ids) {
  const bool dynamic = !frame.instances[segment].dynamic;
  const Reason reason = dynamic ? Reason::kSplit : Reason::kKept;
  if (part.size() == frame.seg.segments[segment].points.size()) {
    frame.instances[segment].dynamic = dynamic;
    frame.instances[segment].reason = reason;
    return;
  }
  const std::size_t child = splitSegment(frame, segment, part);
  Instance& instance = frame.instances[child];
  instance.id = ids.next();
  instance.parent = frame.instances[segment].id;
  instance.dynamic = dynamic;
  instance.reason = reason;
}

/// True when most of the part lies beside what moved, and not under it.
bool isBeside(const KeyFrame& frame, const Indices& part, const Footprint& moved) {
  const auto outside = std::count_if(part.begin(), part.end(), [&](std::uint32_t i) {
    return !moved.contains(frame.scan.points[i].position().head<2>(), kMovedMargin);
  });
  return static_cast<double>(outside) >= kBeside * static_cast<double>(part.size());
}

}  // namespace

void splitMoved(KeyFrame& frame,
                const std::vector<PlaceEvidence>& by_point,
                const Config& config,
                const CurvedGrid& grid,
                IdSource& ids) {
  const std::size_t count = frame.instances.size();
  for (std::size_t s = 0; s < count; ++s) {
    if (frame.instances[s].dynamic) continue;
    const Indices moved = pointsWhere(frame.seg.segments[s], by_point, hasMoved);
    if (moved.size() < static_cast<std::size_t>(config.df.split_min)) continue;
    for (const Indices& part : connectedParts(frame, moved, grid)) {
      if (part.size() < static_cast<std::size_t>(config.df.split_min)) continue;
      separate(frame, s, part, ids);
    }
  }
}

void keepStanding(KeyFrame& frame,
                  const std::vector<PlaceEvidence>& by_point,
                  const Config& config,
                  const CurvedGrid& grid,
                  IdSource& ids) {
  const auto hits = static_cast<std::uint8_t>(config.df.keep_hits);
  const std::size_t count = frame.instances.size();
  for (std::size_t s = 0; s < count; ++s) {
    if (!frame.instances[s].dynamic || frame.instances[s].whole) continue;
    const Indices standing =
        pointsWhere(frame.seg.segments[s], by_point,
                    [hits](const PlaceEvidence& e) { return e.free == 0 && e.hit >= hits; });
    if (standing.size() < static_cast<std::size_t>(config.df.keep_min)) continue;
    const Indices moved = pointsWhere(frame.seg.segments[s], by_point, hasMoved);
    if (moved.empty()) continue;
    const Footprint footprint(seenFromAbove(frame, moved));
    for (const Indices& part : connectedParts(frame, standing, grid)) {
      if (part.size() < static_cast<std::size_t>(config.df.keep_min)) continue;
      if (isBeside(frame, part, footprint)) separate(frame, s, part, ids);
    }
  }
}

}  // namespace segdf

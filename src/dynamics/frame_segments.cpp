// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/frame_segments.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "segdf/classification/classifier.hpp"
#include "segdf/classification/features.hpp"
#include "segdf/core/parallel.hpp"

namespace segdf {

namespace {

Eigen::AlignedBox3f boundsOf(const Scan& scan, const std::vector<std::uint32_t>& points) {
  Eigen::AlignedBox3f bounds;
  for (std::uint32_t i : points) bounds.extend(scan.points[i].position());
  return bounds;
}

void classifySegment(Segment& segment, const ClassConfig& config) {
  segment.object_class = classify(segment.features, segment.points.size(), config);
}

}  // namespace

void describe(KeyFrame& frame, Segment& segment) {
  const Segmentation& seg = frame.seg;
  describeSegment({frame.scan.points, seg.height, seg.row, seg.column, seg.surfaces}, segment);
}

void describeAndClassify(KeyFrame& frame, const ClassConfig& config, int threads) {
  parallelFor(frame.seg.segments.size(), threads, [&](std::size_t s) {
    describe(frame, frame.seg.segments[s]);
    classifySegment(frame.seg.segments[s], config);
  });
}

Eigen::Vector3d centerOf(const KeyFrame& frame, std::size_t segment) {
  return frame.scan.pose * frame.seg.segments[segment].box.center.cast<double>();
}

std::vector<Eigen::Vector2f> seenFromAbove(const KeyFrame& frame,
                                           const std::vector<std::uint32_t>& points) {
  std::vector<Eigen::Vector2f> places;
  places.reserve(points.size());
  for (std::uint32_t i : points) places.emplace_back(frame.scan.points[i].position().head<2>());
  return places;
}

std::vector<Volume> dynamicVolumes(const KeyFrame& frame) {
  std::vector<Volume> volumes;
  for (std::size_t s = 0; s < frame.instances.size(); ++s) {
    const Segment& segment = frame.seg.segments[s];
    if (!frame.instances[s].dynamic || segment.points.empty()) continue;
    volumes.push_back({Footprint(seenFromAbove(frame, segment.points)), segment.bounds.min().z(),
                       segment.bounds.max().z()});
  }
  return volumes;
}

void uniteSegments(KeyFrame& frame,
                   const std::vector<std::uint32_t>& groups,
                   std::size_t count,
                   const ClassConfig& config) {
  std::vector<Segment> united(count);
  std::vector<std::size_t> members(count, 0);
  for (std::size_t s = 0; s < groups.size(); ++s) {
    Segment& source = frame.seg.segments[s];
    Segment& target = united[groups[s]];
    if (members[groups[s]]++ == 0) {
      target = std::move(source);
      continue;
    }
    target.points.insert(target.points.end(), source.points.begin(), source.points.end());
    target.bounds.extend(source.bounds);
  }
  frame.seg.segments = std::move(united);
  frame.instances.assign(count, Instance{});
  for (std::size_t g = 0; g < count; ++g) {
    if (members[g] == 1) continue;
    Segment& segment = frame.seg.segments[g];
    std::sort(segment.points.begin(), segment.points.end());
    describe(frame, segment);
    classifySegment(segment, config);
    frame.instances[g].fused = true;
  }
  for (std::int32_t& cluster : frame.seg.clusters.of_voxel) {
    if (cluster == Clusters::kNoise) continue;
    cluster = static_cast<std::int32_t>(groups[static_cast<std::size_t>(cluster)]);
  }
  frame.seg.clusters.count = count;
}

std::size_t splitSegment(KeyFrame& frame,
                         std::size_t segment,
                         const std::vector<std::uint32_t>& points) {
  Segment part;
  part.points = points;
  part.object_class = frame.seg.segments[segment].object_class;
  part.bounds = boundsOf(frame.scan, points);
  part.box = fitBox(frame.scan.points, points);

  Segment& rest = frame.seg.segments[segment];
  std::vector<std::uint32_t> kept;
  std::set_difference(rest.points.begin(), rest.points.end(), points.begin(), points.end(),
                      std::back_inserter(kept));
  rest.points = std::move(kept);
  rest.bounds = boundsOf(frame.scan, rest.points);
  rest.box = fitBox(frame.scan.points, rest.points);

  frame.seg.segments.push_back(std::move(part));
  frame.instances.emplace_back();
  return frame.seg.segments.size() - 1;
}

}  // namespace segdf

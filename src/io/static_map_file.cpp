// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/static_map_file.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf {

namespace {

constexpr std::size_t kBlock = 65536;  // points handed on at once

MapPoint asDynamic(MapPoint point) {
  point.label = semantic_kitti::kDynamic;
  return point;
}

/// Points handed on to a stream, a block at a time.
class Buffer {
 public:
  explicit Buffer(PcdStream& stream) : stream_(stream) {}

  void add(const MapPoint& point) {
    points_.push_back(point);
    if (points_.size() == kBlock) flush();
  }
  void flush() {
    stream_.add(points_);
    points_.clear();
  }

 private:
  PcdStream& stream_;
  std::vector<MapPoint> points_;
};

}  // namespace

StaticMapFile::StaticMapFile(std::filesystem::path file, double voxel)
    : file_(std::move(file)), stream_(file_) {
  if (voxel > 0.0) voxels_ = std::make_unique<StaticMap>(voxel);
}

void StaticMapFile::add(const FrameResult& frame) {
  if (voxels_) return voxels_->add(frame);
  frames_.push_back({frame.index, stream_.size()});
  stream_.add(mapPointsWhere(frame, isKept));
}

void StaticMapFile::finish(PcdStream& dynamic_points) {
  if (voxels_) {
    for (const Revocation& revocation : revocations_) {
      std::vector<MapPoint> revoked = voxels_->revoke(revocation);
      for (MapPoint& point : revoked) point = asDynamic(point);
      dynamic_points.add(revoked);
    }
    stream_.add(voxels_->points());
  }
  stream_.finish();
  if (!voxels_ && !revocations_.empty()) dropRevoked(dynamic_points);
}

void StaticMapFile::dropRevoked(PcdStream& dynamic_points) const {
  std::unordered_multimap<std::uint32_t, const Revocation*> by_id;
  for (const Revocation& revocation : revocations_) by_id.emplace(revocation.id, &revocation);
  const auto is_revoked = [&by_id](const MapPoint& point, std::size_t scan) {
    const auto [first, last] = by_id.equal_range(point.instance);
    return std::any_of(first, last, [&point, scan](const auto& entry) {
      return isRevoked(point, scan, *entry.second);
    });
  };
  PcdStream remaining(file_.string() + ".remaining");
  Buffer kept(remaining);
  Buffer removed(dynamic_points);
  std::size_t number = 0;
  auto frame = frames_.begin();
  forEachPoint(file_, [&](const MapPoint& point) {
    while (std::next(frame) != frames_.end() && std::next(frame)->first <= number) ++frame;
    ++number;
    if (is_revoked(point, frame->scan)) {
      removed.add(asDynamic(point));
    } else {
      kept.add(point);
    }
  });
  kept.flush();
  removed.flush();
  remaining.finish();
  std::filesystem::rename(file_.string() + ".remaining", file_);
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/mapping/instance_table.hpp"

#include <algorithm>

namespace segdf {

Reason InstanceRecord::reason() const {
  const auto most = std::max_element(frames_by_reason.begin(), frames_by_reason.end());
  return static_cast<Reason>(most - frames_by_reason.begin());
}

void InstanceTable::add(const FrameResult& frame) {
  for (const InstanceObservation& seen : frame.instances) {
    InstanceRecord& record = records_[seen.id];
    record.id = seen.id;
    record.parent = seen.parent;
    ++record.frames;
    record.points += seen.points;
    record.dynamic_points += seen.dynamic ? seen.points : 0;
    record.size = record.size.cwiseMax(seen.size);
    record.static_votes += seen.static_votes;
    record.dynamic_votes += seen.dynamic_votes;
    record.fused = record.fused || seen.fused;
    ++record.frames_by_reason[static_cast<std::size_t>(seen.reason)];
    record.points_by_class[static_cast<std::size_t>(seen.object_class)] += seen.points;
    const auto most =
        std::max_element(record.points_by_class.begin(), record.points_by_class.end());
    record.object_class = static_cast<ObjectClass>(most - record.points_by_class.begin());
  }
}

void InstanceTable::revoke(const Revocation& revocation) {
  InstanceRecord& record = records_[revocation.id];
  record.dynamic_points += revocation.points;
  // Nearly all frames of what stands were decided for one reason, which no longer holds.
  std::size_t& most = record.frames_by_reason[static_cast<std::size_t>(record.reason())];
  most -= std::min(most, revocation.frames);
  record.frames_by_reason[static_cast<std::size_t>(Reason::kLeft)] += revocation.frames;
}

std::vector<InstanceRecord> InstanceTable::records() const {
  std::vector<InstanceRecord> result;
  result.reserve(records_.size());
  for (const auto& [id, record] : records_) result.push_back(record);
  return result;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "segdf/core/frame_result.hpp"

namespace segdf {

/// One row of instances.csv: an instance over all frames in which it was seen.
struct InstanceRecord {
  std::uint32_t id = 0;
  std::uint32_t parent = 0;                          ///< instance from which it was split, 0 = none
  ObjectClass object_class = ObjectClass::kUnknown;  ///< of most of its points
  std::size_t frames = 0;
  std::size_t points = 0;
  std::size_t dynamic_points = 0;                  ///< removed from the map
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< largest length, width, height seen; metres
  std::size_t static_votes = 0;
  std::size_t dynamic_votes = 0;
  bool fused = false;
  std::array<std::size_t, kReasons> frames_by_reason{};  ///< indexed by Reason
  std::array<std::size_t, 5> points_by_class{};          ///< indexed by ObjectClass

  /// "dynamic" if at least half of its points were removed, else "static".
  bool isDynamic() const { return 2 * dynamic_points >= points; }
  /// What decided in most of its frames.
  Reason reason() const;
};

/// Adds up what the frames say of each instance: which item was removed, and why.
class InstanceTable {
 public:
  void add(const FrameResult& frame);
  /// Counts what stood in frames that were added as removed.
  void revoke(const Revocation& revocation);

  /// Ordered by id.
  std::vector<InstanceRecord> records() const;

 private:
  std::map<std::uint32_t, InstanceRecord> records_;
};

}  // namespace segdf

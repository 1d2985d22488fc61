// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/io/pcd_stream.hpp"
#include "segdf/mapping/static_map.hpp"

namespace segdf {

/// static_map.pcd while a drive is filtered: at full resolution on disk, frame by frame; thinned in
/// memory, by voxels. What is revoked is taken out at the end.
class StaticMapFile {
 public:
  /// @param voxel edge of the grid, metres; 0 = every point @throws IoError
  StaticMapFile(std::filesystem::path file, double voxel);

  /// Adds the kept points of a frame; frames come in the order of their index. @throws IoError
  void add(const FrameResult& frame);
  void revoke(const Revocation& revocation) { revocations_.push_back(revocation); }

  /// Writes the map. @param dynamic_points gets the points that were revoked @throws IoError
  void finish(PcdStream& dynamic_points);
  /// Makes whole what was written so far, revoked points included. @throws IoError
  void salvage() { stream_.finish(); }

 private:
  struct FrameStart {
    std::size_t scan = 0;
    std::size_t first = 0;  ///< point of the stream
  };

  void dropRevoked(PcdStream& dynamic_points) const;

  std::filesystem::path file_;
  PcdStream stream_;
  std::unique_ptr<StaticMap> voxels_;  ///< only with a voxel
  std::vector<FrameStart> frames_;
  std::vector<Revocation> revocations_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "segdf/core/frame_result.hpp"
#include "segdf/io/output_folder.hpp"

namespace segdf::apps {

/// Segments and classes of each scan for people to look at: instances/NNNNNN.pcd and
/// classes/NNNNNN.pcd (map frame, fields as static_map.pcd and rgb), and beside each a picture from
/// above, 50 m around the sensor at 0.1 m a pixel, the x axis of the map to the right. What moves
/// has the colour of its instance or class like all else. The folder gets everything or nothing.
class SegmentDump {
 public:
  /// @throws IoError when the folder cannot be written
  explicit SegmentDump(const std::filesystem::path& folder);

  /// @throws IoError when the disk is full
  void add(const FrameResult& frame);
  /// Moves everything into place. @throws IoError
  void finish() { folder_.commit(); }

 private:
  OutputFolder folder_;
};

}  // namespace segdf::apps

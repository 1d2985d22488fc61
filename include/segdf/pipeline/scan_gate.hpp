// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"

namespace segdf {

/// Decides whether a scan becomes a key frame, or why not (method.md 1).
class ScanGate {
 public:
  explicit ScanGate(const InputConfig& config) : config_(config) {}

  /// kMapped makes this scan the last key frame; any other status leaves the gate as it was, but
  /// for the stamp of a scan between key frames.
  FrameStatus admit(const Scan& scan);

 private:
  struct KeyPose {
    Pose pose;
    double seconds = 0.0;
  };

  bool isKeyFrame(const Scan& scan) const;

  InputConfig config_;
  std::optional<std::int64_t> last_stamp_ns_;
  std::optional<KeyPose> last_key_;
};

}  // namespace segdf

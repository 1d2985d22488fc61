// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Writes a drive in KITTI's layout: velodyne/, labels/ (with truth only), poses.txt in the camera
/// frame of the first scan with its calib.txt, times.txt, and poses_gt.txt with the exact poses in
/// the same frame.
class KittiWriter {
 public:
  /// @throws IoError when the folder cannot be made or holds scans already: a drive is never
  /// overwritten
  explicit KittiWriter(const std::filesystem::path& folder);

  /// @param truth one label for each point, or empty
  /// @param exact_pose map_T_sensor without the noise that scan.pose may carry
  void add(const Scan& scan, const std::vector<std::uint32_t>& truth, const Pose& exact_pose);

  /// Writes poses, calibration and times. A drive without them is not finished, and no reader takes
  /// it.
  void finish();

 private:
  std::filesystem::path folder_;
  std::vector<Pose> poses_;
  std::vector<Pose> exact_poses_;
  std::vector<double> times_;
};

}  // namespace segdf

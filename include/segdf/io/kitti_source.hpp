// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "segdf/io/frame_range.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

/// A drive in KITTI's layout: velodyne/NNNNNN.bin (float32 x y z intensity), in the order of the
/// names, and
///   poses.txt with calib.txt: row i is camera0_T_camera of scan i, `Tr` is camera_T_lidar; or
///   poses_lidar.txt: row i is map_T_lidar of scan i, no calibration needed.
/// times.txt (seconds) is optional. The map frame of poses.txt is the lidar frame of its first
/// row's origin: Tr^-1 P Tr.
class KittiSource : public ScanSource {
 public:
  /// @param assumed_rate_hz scans a second where there is no times.txt
  /// @param frames the scans that next() gives; poses stay in the frame of the whole drive
  /// @throws IoError naming the folder, the missing file, both counts that differ, or the frames
  /// that the drive does not have
  explicit KittiSource(const std::filesystem::path& folder,
                       double assumed_rate_hz = 10.0,
                       const FrameRange& frames = {});

  /// @throws IoError when a file's size is no multiple of 16 bytes or it cannot be read
  std::optional<Scan> next() override;
  /// As next(), in a quarter of the time, with every ring unknown.
  std::optional<Scan> nextWithoutRings();
  std::size_t size() const override { return selected_.size(); }
  /// Scans of the whole drive.
  std::size_t sizeOfDrive() const { return files_.size(); }
  std::string describe() const override;

  /// True when there was no times.txt and the stamps are made up.
  bool timesAssumed() const { return times_assumed_; }
  /// Position in the whole drive of the scan that next() gives as number i.
  std::size_t positionOf(std::size_t i) const { return selected_[i]; }
  /// Name of that scan without extension, e.g. "000012".
  std::string nameOf(std::size_t i) const { return files_[selected_[i]].stem().string(); }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
  std::vector<Pose> poses_;
  std::vector<double> times_;          // seconds
  std::vector<std::size_t> selected_;  // positions in the lists above
  bool times_assumed_ = false;
  std::size_t next_ = 0;
};

/// Camera axes seen from a lidar with x forward: calibration of the drives that segdf writes
/// itself, and the `Tr` that stands in their calib.txt. camera_T_lidar.
Pose defaultCalibration();

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include <rosbag/bag.h>

#include "segdf/core/scan.hpp"
#include "segdf/io/atomic_file.hpp"

namespace segdf {

/// In which of LIO-SAM's two forms clouds are written.
enum class CloudForm {
  kRegistered,  ///< in the odometry frame, x y z intensity
  kSensor,      ///< in the sensor frame, with ring (when known) and time
};

/// Writes a drive as a bag such as LIO-SAM would have made it: cloud, odometry and /tf, all with
/// the scan's stamp, and the ground truth on a topic of its own (ros/topics.hpp).
///
/// A drive that starts at stamp 0 is moved by kEpochNs, because ROS takes time 0 for "not set". The
/// bag is written to "<file>.partial" and gets its name in finish(): it is there whole or not at
/// all.
class BagWriter {
 public:
  static constexpr std::int64_t kEpochNs = 1'000'000'000'000'000;  ///< 1,000,000 s

  /// @throws IoError if `file` exists (unless `overwrite`) or its folder cannot be written
  BagWriter(const std::filesystem::path& file, CloudForm form, bool overwrite = false);
  /// Takes away what is unfinished.
  ~BagWriter();
  BagWriter(const BagWriter&) = delete;
  BagWriter& operator=(const BagWriter&) = delete;

  /// @param truth one SemanticKITTI label for each point, or empty: not known
  /// @throws IoError if the disk is full, the stamp cannot be a ROS time, or the counts differ
  void add(const Scan& scan, const std::vector<std::uint32_t>& truth = {});

  /// Closes the bag and gives it its name. @throws IoError
  void finish();

 private:
  void write(const Scan& scan, const std::vector<std::uint32_t>& truth);

  void close();

  AtomicFile file_;
  CloudForm form_;
  bool first_ = true;
  std::int64_t offset_ns_ = 0;
  std::unique_ptr<rosbag::Bag> bag_;
};

}  // namespace segdf

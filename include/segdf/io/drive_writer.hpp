// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/io/evidence_log.hpp"
#include "segdf/io/output_folder.hpp"
#include "segdf/io/pcd_stream.hpp"
#include "segdf/io/run_report.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/io/static_map_file.hpp"
#include "segdf/mapping/instance_table.hpp"

namespace segdf {

/// Writes everything that a drive leaves behind: static_map.pcd, dynamic_points.pcd,
/// labels/NNNNNN.label, instances.csv, evidence.csv, config.yaml, report.json and map.png
/// (layout.md 6). Maps go to disk frame by frame.
class DriveWriter {
 public:
  /// @throws IoError when the folder cannot be written
  DriveWriter(const std::filesystem::path& folder, const Config& config);

  /// Adds a frame; frames come in the order of their index. @throws IoError when the disk is full
  void add(const FrameResult& frame);

  /// Writes tables, report and picture, and moves everything into place. @throws IoError
  void finish();

  RunReport& report() { return report_; }
  /// After a failure: makes the maps in the staging folder whole, as far as they were written.
  /// @throws IoError with the reason, and where they are
  [[noreturn]] void abandon(const IoError& reason);

 private:
  void salvage() noexcept;
  void revoke(const Revocation& revocation);
  std::filesystem::path labelsOf(std::size_t scan) const;
  void writeInstances();
  void drawMap() const;

  Config config_;
  OutputFolder folder_;
  StaticMapFile static_points_;
  PcdStream dynamic_points_;
  InstanceTable instances_;
  EvidenceLog evidence_;
  RunReport report_;
  std::vector<Eigen::Vector2d> trajectory_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "segdf/core/config.hpp"
#include "segdf/io/drive_writer.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf::apps {

/// What the command line of segdf_offline says.
struct OfflineOptions {
  std::filesystem::path bag;
  std::filesystem::path kitti;
  std::filesystem::path output;
  std::filesystem::path config;
  std::string frames;  ///< of the folder, as parseFrameRange reads them; empty: all
  std::string sensor;  ///< empty: recognised from the first scan
  std::string mode;    ///< empty: as configured
  std::string cloud_topic;
  std::string odometry_topic;
  double rate = 10.0;
  int threads = 1;
};

/// Filters one drive: source -> pipeline -> writer. Prints warnings and progress.
class OfflineRunner {
 public:
  explicit OfflineRunner(OfflineOptions options) : options_(std::move(options)) {}

  /// @returns an ExitCode. @throws IoError when nothing could be done
  int run();

 private:
  std::unique_ptr<ScanSource> openSource() const;
  Config configure(const std::optional<Scan>& first);
  std::optional<Scan> nextScan(ScanSource& source);
  void filter(ScanSource& source,
              std::optional<Scan> scan,
              DriveWriter& writer,
              const Config& config);
  int finish(DriveWriter& writer, const Config& config);
  void warn(const std::string& message) const;

  OfflineOptions options_;
  std::string sensor_;
  std::string break_off_;  ///< why the input ended early, empty if it did not
};

}  // namespace segdf::apps

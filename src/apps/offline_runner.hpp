// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "segdf/core/config.hpp"
#include "segdf/io/drive_writer.hpp"
#include "segdf/io/scan_source.hpp"

#include "drive_input.hpp"

namespace segdf::apps {

/// What the command line of segdf_offline says.
struct OfflineOptions {
  DriveInput input;
  std::filesystem::path output;
  std::filesystem::path segments;  ///< for coloured clouds of each scan; empty: none
  std::string mode;                ///< empty: as configured
  int threads = 2;
};

/// Filters one drive: source -> pipeline -> writer. Prints warnings and progress.
class OfflineRunner {
 public:
  explicit OfflineRunner(OfflineOptions options) : options_(std::move(options)) {}

  /// @returns an ExitCode. @throws IoError when nothing could be done
  int run();

 private:
  Config configure(const std::optional<Scan>& first);
  std::optional<Scan> nextScan(ScanSource& source);
  void filter(ScanSource& source,
              std::optional<Scan> scan,
              const Config& config,
              const std::function<void(const FrameResult&)>& take);
  int finish(DriveWriter& writer, const Config& config);

  OfflineOptions options_;
  std::string sensor_;
  std::string break_off_;  ///< why the input ended early, empty if it did not
};

}  // namespace segdf::apps

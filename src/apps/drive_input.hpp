// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "segdf/core/config.hpp"
#include "segdf/io/scan_source.hpp"

#include <CLI/CLI.hpp>

namespace segdf::apps {

/// Which drive a program reads, and the sensor and parameters that go with it.
struct DriveInput {
  std::filesystem::path bag;
  std::filesystem::path kitti;
  std::filesystem::path config;
  std::string frames;  ///< of the folder, as parseFrameRange reads them; empty: all
  std::string sensor;  ///< empty: recognised from the first scan
  std::string cloud_topic;
  std::string odometry_topic;
  double rate = 10.0;  ///< scans a second of a folder without times.txt
};

/// Adds the options that fill `input`.
void addDriveOptions(CLI::App& app, DriveInput& input);

/// For the callback of the command line. @throws CLI::Error when no drive is named, or options do
/// not go together
void checkDriveOptions(const DriveInput& input);

/// Opens the drive and warns of clouds without a pose and of assumed times. @throws IoError
std::unique_ptr<ScanSource> openDrive(const DriveInput& input);

/// Parameters for a drive, and the sensor that they are of.
struct DriveConfig {
  std::string sensor;
  Config config;
};

/// The sensor's parameters with those of the file; says which sensor was recognised.
/// @throws IoError
DriveConfig configureDrive(const DriveInput& input, const std::optional<Scan>& first);

/// One line on standard error, "warning: ...".
void warn(const std::string& message);

}  // namespace segdf::apps

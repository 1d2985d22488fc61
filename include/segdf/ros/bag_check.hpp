// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "segdf/ros/bag_report.hpp"
#include "segdf/ros/bag_source.hpp"

/// Is a bag good for segdf? Checked before anyone waits for it (docs/bags.md lists the messages).
namespace segdf {

struct BagCheckOptions {
  BagTopics topics;        ///< as BagSource takes them
  bool all_scans = false;  ///< look into every scan, not only at kSampledPlaces
};

/// Places, spread evenly over the drive, at which two consecutive scans are looked into.
constexpr std::size_t kSampledPlaces = 10;

/// Makes every check. Whatever makes the bag unusable is in the report's `errors`. Reads the bag
/// once for stamps and poses, and again up to the last scan that is looked into.
/// @throws IoError if the bag cannot be opened
BagReport checkBag(const std::filesystem::path& bag, const BagCheckOptions& options);

/// Command lines that run segdf on the bag, to be pasted into a shell.
/// @param more arguments of the launch file
std::string offlineCommand(const std::filesystem::path& bag, const BagTopics& topics);
std::string launchCommand(const std::filesystem::path& bag,
                          const BagTopics& topics,
                          const std::string& more = "");

}  // namespace segdf

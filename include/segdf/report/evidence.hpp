// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace segdf {

/// Why instances were removed: rows of a run's instances.csv with whatever columns it has.
struct Evidence {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> removed;  ///< most points first
};

/// The rows of an instances.csv whose column `verdict` says "dynamic".
/// @throws IoError when the file cannot be read, or has no columns id, points and verdict
Evidence readEvidence(const std::filesystem::path& file);

}  // namespace segdf

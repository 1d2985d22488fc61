// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/io/atomic_file.hpp"

namespace segdf {

/// Writes evidence.csv: why each instance was kept or removed in each scan. One row for each
/// instance and scan; of the looks of other scans only those are listed that saw through more than
/// a tenth of it, since nearly all others say "found again", and these are counted.
class EvidenceLog {
 public:
  /// @throws IoError when the file cannot be created
  explicit EvidenceLog(const std::filesystem::path& file);

  /// @throws IoError when the disk is full
  void add(const FrameResult& frame);
  void finish() { file_.commit(); }

 private:
  AtomicFile file_;
};

/// One row of evidence.csv as text, by column.
struct EvidenceRow {
  std::size_t scan = 0;
  std::uint32_t instance = 0;
  std::uint32_t parent = 0;
  std::string verdict;  ///< "static" or "dynamic"
  std::string reason;
  std::string object_class;
  std::size_t points = 0;
  std::size_t looks = 0;
  std::size_t dynamic_votes = 0;
  std::size_t static_votes = 0;
  std::size_t needed_votes = 0;
  std::string center;      ///< x y z in the map frame, metres
  std::string free_looks;  ///< scan:seconds:free/seen, separated by spaces
};

/// The rows of one instance and of the parts that were split off it, in the order of the scans.
/// @throws IoError when the file cannot be read, or is no evidence.csv
std::vector<EvidenceRow> readEvidence(const std::filesystem::path& file, std::uint32_t instance);

}  // namespace segdf

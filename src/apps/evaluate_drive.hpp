// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/io/frame_range.hpp"

namespace segdf::apps {

/// A scan with its ground truth and, where labels are scored, with a run's labels.
struct LabelledScan {
  Scan scan;
  std::vector<std::uint32_t> truth;
  std::vector<std::uint32_t> estimate;  ///< empty when a map is scored
};

/// A KITTI folder with labels/, and a folder of labels to be scored, or none.
class LabelledDrive {
 public:
  /// @throws IoError when scans, truth and labels do not belong together
  LabelledDrive(std::filesystem::path kitti,
                std::filesystem::path labels,
                const FrameRange& frames);

  std::size_t size() const { return truth_files_.size(); }
  const std::filesystem::path& folder() const { return kitti_; }
  const std::filesystem::path& labels() const { return labels_; }
  /// Name of the folder, for people.
  std::string name() const;

  /// Reads the drive from its start; one scan is in memory at a time. @throws IoError
  void forEach(const std::function<void(const LabelledScan&)>& visit) const;

 private:
  std::filesystem::path kitti_;
  std::filesystem::path labels_;
  FrameRange frames_;
  std::vector<std::filesystem::path> truth_files_;
  std::vector<std::filesystem::path> estimate_files_;  ///< empty when a map is scored
};

}  // namespace segdf::apps

// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_drive.hpp"

#include <algorithm>
#include <utility>

#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/scan_name.hpp"

namespace segdf::apps {

namespace fs = std::filesystem;

namespace {

constexpr double kAnyRate = 10.0;  // stamps do not matter here

std::size_t countLabels(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw IoError("no folder " + folder.string() + " with .label files");
  return static_cast<std::size_t>(
      std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                    [](const auto& entry) { return entry.path().extension() == ".label"; }));
}

IoError wrongCount(std::size_t labels, const fs::path& folder, std::size_t scans) {
  return IoError(std::to_string(labels) + " label files in " + folder.string() + " for " +
                 std::to_string(scans) + " scans; are they of the same drive?");
}

/// One label file for each scan. The labels are of the selected scans only, or of the whole drive.
std::vector<fs::path> estimateFiles(const KittiSource& source, const fs::path& folder) {
  const std::size_t labels = countLabels(folder);
  const bool of_whole_drive = labels == source.sizeOfDrive();
  if (!of_whole_drive && labels != source.size()) throw wrongCount(labels, folder, source.size());
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < source.size(); ++i) {
    // segdf numbers its label files from 0, whatever the scans are called.
    files.push_back(folder / (scanName(of_whole_drive ? source.positionOf(i) : i) + ".label"));
  }
  return files;
}

std::vector<fs::path> truthFiles(const KittiSource& source, const fs::path& folder) {
  const std::size_t labels = countLabels(folder);
  if (labels != source.sizeOfDrive()) throw wrongCount(labels, folder, source.sizeOfDrive());
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < source.size(); ++i) {
    files.push_back(folder / (source.nameOf(i) + ".label"));
  }
  return files;
}

std::vector<std::uint32_t> readFor(const fs::path& file, std::size_t points) {
  std::vector<std::uint32_t> labels = readLabels(file);
  if (labels.size() == points) return labels;
  throw IoError("label file " + file.string() + " has " + std::to_string(labels.size()) +
                " labels for a scan of " + std::to_string(points) +
                " points; is it of the same drive?");
}

}  // namespace

LabelledDrive::LabelledDrive(fs::path kitti, fs::path labels, const FrameRange& frames)
    : kitti_(std::move(kitti)), labels_(std::move(labels)), frames_(frames) {
  const KittiSource source(kitti_, kAnyRate, frames_);
  truth_files_ = truthFiles(source, kitti_ / "labels");
  if (!labels_.empty()) estimate_files_ = estimateFiles(source, labels_);
}

std::string LabelledDrive::name() const {
  const fs::path path = fs::absolute(kitti_).lexically_normal();
  return (path.has_filename() ? path.filename() : path.parent_path().filename()).string();
}

void LabelledDrive::forEach(const std::function<void(const LabelledScan&)>& visit) const {
  KittiSource source(kitti_, kAnyRate, frames_);
  for (std::size_t i = 0; i < size(); ++i) {
    LabelledScan labelled;
    labelled.scan = *source.nextWithoutRings();
    const std::size_t points = labelled.scan.points.size();
    labelled.truth = readFor(truth_files_[i], points);
    if (!estimate_files_.empty()) labelled.estimate = readFor(estimate_files_[i], points);
    visit(labelled);
  }
}

}  // namespace segdf::apps

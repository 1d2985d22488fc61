// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/drive_recorder.hpp"

#include <utility>

#include "segdf/io/output_folder.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

DriveRecorder::DriveRecorder(std::filesystem::path folder) : folder_(std::move(folder)) {
  const OutputFolder tried(folder_);
}

std::filesystem::path DriveRecorder::sessionFolder() const {
  return sessions_ == 1 ? folder_ : folder_ / ("session_" + std::to_string(sessions_));
}

void DriveRecorder::open(const Config& config, const RunReport::Setting& setting) {
  ++sessions_;
  writer_ = std::make_unique<DriveWriter>(sessionFolder(), config);
  writer_->report().setSetting(setting);
}

template <class Action>
void DriveRecorder::orClose(const Action& action) {
  try {
    action();
  } catch (const IoError& error) {
    const std::unique_ptr<DriveWriter> failed = std::move(writer_);
    failed->abandon(error);
  }
}

void DriveRecorder::add(const FrameResult& frame) {
  orClose([&] { writer_->add(frame); });
}

std::string DriveRecorder::finish() {
  if (!writer_) return "";
  orClose([this] { writer_->finish(); });
  writer_.reset();
  return sessionFolder().string();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/io/drive_writer.hpp"
#include "segdf/io/run_report.hpp"

namespace segdf {

/// Writes each session, from its first frame to finish(), as segdf_offline would: the first into
/// the folder itself, later ones into session_2, session_3, ... in it.
class DriveRecorder {
 public:
  /// Makes the folder. @throws IoError if it cannot be written
  explicit DriveRecorder(std::filesystem::path folder);

  bool isOpen() const { return writer_ != nullptr; }
  /// @throws IoError if the session's folder cannot be written
  void open(const Config& config, const RunReport::Setting& setting);
  /// @pre isOpen() @throws IoError when the disk is full; the session is then closed, and what was
  /// written is left in its folder `partial`
  void add(const FrameResult& frame);
  /// Moves the session's files into place; without a session does nothing.
  /// @return the folder that holds them, "" without a session @throws IoError
  std::string finish();

 private:
  std::filesystem::path sessionFolder() const;
  template <class Action>
  void orClose(const Action& action);

  std::filesystem::path folder_;
  std::size_t sessions_ = 0;
  std::unique_ptr<DriveWriter> writer_;
};

}  // namespace segdf

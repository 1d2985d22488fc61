// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/core/stopwatch.hpp"

namespace segdf {

/// What a run did and what it cost: adds up frames, measures time and memory of the process.
class RunReport {
 public:
  /// Where the drive came from and how it was run; told in the report.
  struct Setting {
    std::string source;
    std::string sensor;
    std::string mode;
    int threads = 1;
  };

  void setSetting(const Setting& setting) { setting_ = setting; }
  void add(const FrameResult& frame);
  /// Counts static points as dynamic ones.
  void revoke(const Revocation& revocation);

  std::size_t frames() const { return frames_; }
  std::size_t mapped() const { return count(FrameStatus::kMapped); }
  std::size_t count(FrameStatus status) const {
    return by_status_[static_cast<std::size_t>(status)];
  }
  /// First scan with a status; meaningful when count() is not 0.
  std::size_t firstOf(FrameStatus status) const {
    return first_of_status_[static_cast<std::size_t>(status)];
  }
  /// Times the pose jumped and the window started anew.
  std::size_t jumps() const { return jumps_; }
  std::size_t nonFinitePoints() const { return non_finite_points_; }
  /// Median over key frames, metres; NaN when it was never measurable.
  double medianMisfit() const;

  /// @param instances rows of instances.csv, of which `removed` are dynamic
  void setInstances(std::size_t instances, std::size_t removed);

  /// report.json. @throws IoError
  void write(const std::filesystem::path& file) const;
  /// A few lines for the terminal.
  std::string summary() const;

 private:
  double wallSeconds() const;

  Setting setting_;
  Stopwatch watch_;
  std::size_t frames_ = 0;
  std::array<std::size_t, 5> by_status_{};        ///< indexed by FrameStatus
  std::array<std::size_t, 5> first_of_status_{};  ///< indexed by FrameStatus
  std::array<std::size_t, 5> by_state_{};         ///< points, indexed by PointState
  std::size_t jumps_ = 0;
  std::size_t non_finite_points_ = 0;
  std::size_t instances_ = 0;
  std::size_t removed_instances_ = 0;
  std::vector<double> misfits_;
  StageTimes times_;
};

}  // namespace segdf

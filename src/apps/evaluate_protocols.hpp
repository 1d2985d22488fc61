// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "segdf/evaluation/drive_scores.hpp"
#include "segdf/io/map_file.hpp"

#include "evaluate_drive.hpp"

namespace segdf::apps {

/// Which protocols to score with, and their settings.
struct ProtocolChoice {
  bool index = false;
  bool draft = false;
  bool erasor = false;
  bool map = false;      ///< DynamicMap benchmark
  double range = 50.0;   ///< metres
  double spacing = 2.0;  ///< of the draft's scans, metres
  /// ERASOR without points of class 0: labels made from boxes of one camera's view say so of all
  /// that was not looked at, what moves there included.
  bool judged_only = false;
  int threads = 1;  ///< same figures with any
};

/// Scores the labels of a drive. @throws IoError
DriveScores scoreLabels(const LabelledDrive& drive, const ProtocolChoice& choice);

/// Scores a map against a drive's truth. Classes for ERASOR's protocol are the map's own labels
/// where it has them, else those of the nearest points of the truth.
/// @throws IoError when the map does not lie on the truth
DriveScores scoreMap(const LabelledDrive& drive, const MapCloud& map, const ProtocolChoice& choice);

}  // namespace segdf::apps

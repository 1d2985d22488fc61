// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/evaluation/point_scores.hpp"

namespace segdf {

/// Scores labels against ground truth point by point, by index: the DynamicMap benchmark's SA and
/// DA (peers.md 3.1, method.md 7.3 and 7.4) without the ambiguity of nearest neighbours. Nothing
/// beyond the range is scored. A point is kept iff isKeptLabel says so.
class IndexProtocol {
 public:
  /// @param range metres from the sensor, inclusive
  explicit IndexProtocol(double range = 50.0) : range_(range) {}

  /// Adds one scan. The three lists hold the same points. @throws std::invalid_argument when they
  /// do not
  void add(const std::vector<Point>& points,
           const std::vector<std::uint32_t>& truth,
           const std::vector<std::uint32_t>& estimate);

  const PointScores& scores() const { return scores_; }

 private:
  double range_;
  PointScores scores_;
};

/// True iff a point with this estimated label is in the map: its class is neither 0 (not judged)
/// nor 251 (dynamic).
bool isKeptLabel(std::uint32_t estimate);

}  // namespace segdf

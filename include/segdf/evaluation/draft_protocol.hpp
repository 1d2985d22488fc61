// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "segdf/core/scan.hpp"
#include "segdf/evaluation/point_scores.hpp"
#include "segdf/evaluation/voxel_filter.hpp"

namespace segdf {

/// Verdict of the draft's section IV on one point of the compared maps.
enum class MapVerdict : std::uint8_t {
  kTruePositive,   ///< estimated static, and there in the static truth
  kFalsePositive,  ///< estimated static, but not there in the static truth
  kFalseNegative,  ///< static truth that the estimate has lost
};

/// Figures of the draft's section IV; static is positive.
struct DraftScores {
  std::size_t true_positive = 0;
  std::size_t false_positive = 0;
  std::size_t false_negative = 0;
  Share rejected_dynamic;  ///< TN, of all points of the dynamic truth
  std::vector<Eigen::Vector3f> points;
  std::vector<MapVerdict> verdicts;  ///< of each of `points`: the coloured map

  std::optional<double> precision() const;  ///< TP / (TP + FP), percent
  std::optional<double> recall() const;     ///< TP / (TP + FN), percent
  std::optional<double> f1() const;         ///< harmonic mean of both, 0..1
};

/// The draft's section IV as method.md 7.1 has it: scans every 2 m; the static truth, the dynamic
/// truth and the estimate each on voxels of 0.05 m (centroids); a point appears in another map when
/// its nearest neighbour there is within 0.1 m. Precision is above 99 % even if nothing is removed:
/// never report it alone.
class DraftProtocol {
 public:
  static constexpr double kVoxel = 0.05;        ///< metres
  static constexpr double kCoAppearance = 0.1;  ///< metres, inclusive
  static constexpr double kSpacing = 2.0;       ///< metres

  /// @param range metres from the sensor, inclusive
  explicit DraftProtocol(double range = 50.0, int threads = 1) : range_(range), threads_(threads) {}

  /// Adds a scan of the truth. Where `estimate` is not empty it holds a label for each point, and
  /// the estimated map is made of the scored points that are kept.
  /// @throws std::invalid_argument when the lists differ in length
  void add(const Scan& scan,
           const std::vector<std::uint32_t>& truth,
           const std::vector<std::uint32_t>& estimate);

  /// Scores the estimate of the labels.
  DraftScores score() const;
  /// Scores a map (frame of the scans' poses). Its voxels that lie within kCoAppearance of unscored
  /// truth (classes 0 and 1, out of range) and of no scored truth are left out, as they are from
  /// the truth.
  DraftScores score(const std::vector<Eigen::Vector3f>& map) const;

 private:
  double range_;
  int threads_;
  std::vector<Eigen::Vector3f> static_;
  std::vector<Eigen::Vector3f> dynamic_;
  std::vector<Eigen::Vector3f> unscored_;
  std::vector<Eigen::Vector3f> estimate_;
};

/// Picks scans along the way: the first, and each that is at least `spacing` metres from the last
/// one picked.
class SpacedScans {
 public:
  explicit SpacedScans(double spacing) : spacing_(spacing) {}
  bool pick(const Pose& pose);

 private:
  double spacing_;
  std::optional<Eigen::Vector3d> last_;
};

}  // namespace segdf

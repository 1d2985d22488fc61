// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "segdf/core/frame_result.hpp"
#include "segdf/evaluation/point_scores.hpp"

namespace segdf::apps {

/// What scans look like, in figures by which simulated and real ones can be compared.
class ScanStatistics {
 public:
  /// @param truth one label for each point, or empty
  void add(const FrameResult& frame, const std::vector<std::uint32_t>& truth);

  /// Names with values, always the same names in the same order; nothing where there was no data.
  std::vector<std::pair<std::string, std::optional<double>>> rows() const;

 private:
  static constexpr std::array<double, 7> kRanges{0, 5, 10, 20, 30, 50, 1000};  // metres
  static constexpr std::size_t kRangeBands = kRanges.size() - 1;
  static constexpr std::size_t kRingGroups = 4;

  struct Mean {
    double sum = 0.0;
    std::size_t count = 0;
    void add(double value) {
      sum += value;
      ++count;
    }
    std::optional<double> value() const;
  };

  void addRings(const std::vector<Point>& points);
  void addPoints(const FrameResult& frame, const std::vector<std::uint32_t>& truth);
  void addClusters(const FrameResult& frame);
  void addNeighbours(const FrameResult& frame, const std::vector<std::uint32_t>& truth);
  void addLooks(const FrameResult& frame, const std::vector<std::uint32_t>& truth);

  Mean points_;
  std::array<Mean, kRingGroups> ring_points_;
  Share returns_;
  std::array<Share, kRangeBands> by_range_;
  Share ground_;        // as the filter finds it
  Share truth_ground_;  // as the labels say
  Mean clusters_;
  std::vector<double> cluster_points_;
  std::vector<double> cluster_lengths_;                              // metres
  std::map<std::pair<std::uint16_t, std::size_t>, Mean> intensity_;  // by class and range band
  std::vector<double> neighbour_distances_;                          // metres
  std::vector<double> free_shares_;    // F of what stands, a value for each look of another scan
  std::vector<Eigen::Vector3f> last_;  // points of the scan before, that stand up from the ground
  Pose last_pose_ = Pose::Identity();
};

}  // namespace segdf::apps

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/draft_protocol.hpp"

#include <stdexcept>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/index_protocol.hpp"
#include "segdf/evaluation/map_protocol.hpp"

namespace segdf {

namespace {

std::optional<double> ratio(std::size_t part, std::size_t rest) {
  return Share{part, part + rest}.percent();
}

/// One of the three maps: its voxels, ready to be searched.
class VoxelMap {
 public:
  explicit VoxelMap(const std::vector<Eigen::Vector3f>& points)
      : centroids_(voxelCentroids(points, DraftProtocol::kVoxel)),
        grid_(centroids_, DraftProtocol::kCoAppearance) {}

  const std::vector<Eigen::Vector3f>& centroids() const { return centroids_; }
  /// 1 for each point that appears in this map, else 0.
  std::vector<std::uint8_t> shows(const std::vector<Eigen::Vector3f>& points, int threads) const {
    return grid_.haveWithin(points, DraftProtocol::kCoAppearance, threads);
  }

 private:
  std::vector<Eigen::Vector3f> centroids_;
  PointGrid grid_;
};

DraftScores compare(const VoxelMap& truth,
                    const VoxelMap& dynamic,
                    const VoxelMap& estimate,
                    int threads) {
  DraftScores scores;
  const auto note = [&scores](const Eigen::Vector3f& point, MapVerdict verdict) {
    scores.points.push_back(point);
    scores.verdicts.push_back(verdict);
  };
  const std::vector<std::uint8_t> right = truth.shows(estimate.centroids(), threads);
  for (std::size_t i = 0; i < right.size(); ++i) {
    ++(right[i] != 0 ? scores.true_positive : scores.false_positive);
    note(estimate.centroids()[i],
         right[i] != 0 ? MapVerdict::kTruePositive : MapVerdict::kFalsePositive);
  }
  const std::vector<std::uint8_t> kept = estimate.shows(truth.centroids(), threads);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != 0) continue;
    ++scores.false_negative;
    note(truth.centroids()[i], MapVerdict::kFalseNegative);
  }
  for (const std::uint8_t remains : estimate.shows(dynamic.centroids(), threads)) {
    scores.rejected_dynamic.count(remains == 0);
  }
  return scores;
}

}  // namespace

std::optional<double> DraftScores::precision() const {
  return ratio(true_positive, false_positive);
}

std::optional<double> DraftScores::recall() const { return ratio(true_positive, false_negative); }

std::optional<double> DraftScores::f1() const {
  const std::size_t errors = false_positive + false_negative;
  if (true_positive + errors == 0) return std::nullopt;
  return 2.0 * static_cast<double>(true_positive) / static_cast<double>(2 * true_positive + errors);
}

void DraftProtocol::add(const Scan& scan,
                        const std::vector<std::uint32_t>& truth,
                        const std::vector<std::uint32_t>& estimate) {
  if (truth.size() != scan.points.size() ||
      (!estimate.empty() && estimate.size() != truth.size())) {
    throw std::invalid_argument("points and labels differ in number");
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Eigen::Vector3f in_sensor = scan.points[i].position();
    if (!in_sensor.allFinite()) continue;
    const Eigen::Vector3f place = inMapFrame(scan.pose, scan.points[i]);
    const std::uint16_t semantic_class = semantic_kitti::classOf(truth[i]);
    if (semantic_kitti::isIgnored(semantic_class) || in_sensor.cast<double>().norm() > range_) {
      unscored_.push_back(place);
      continue;
    }
    (semantic_kitti::isMoving(semantic_class) ? dynamic_ : static_).push_back(place);
    if (!estimate.empty() && isKeptLabel(estimate[i])) estimate_.push_back(place);
  }
}

DraftScores DraftProtocol::score() const {
  return compare(VoxelMap(static_), VoxelMap(dynamic_), VoxelMap(estimate_), threads_);
}

DraftScores DraftProtocol::score(const std::vector<Eigen::Vector3f>& map) const {
  const VoxelMap truth(static_);
  const VoxelMap dynamic(dynamic_);
  const std::vector<Eigen::Vector3f> voxels = voxelCentroids(map, kVoxel);
  const std::vector<std::uint8_t> in_static = truth.shows(voxels, threads_);
  const std::vector<std::uint8_t> in_dynamic = dynamic.shows(voxels, threads_);
  const std::vector<std::uint8_t> in_unscored = VoxelMap(unscored_).shows(voxels, threads_);
  std::vector<Eigen::Vector3f> scored;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const bool left_out = in_unscored[i] != 0 && in_static[i] == 0 && in_dynamic[i] == 0;
    if (!left_out) scored.push_back(voxels[i]);
  }
  return compare(truth, dynamic, VoxelMap(scored), threads_);
}

bool SpacedScans::pick(const Pose& pose) {
  const Eigen::Vector3d place = pose.translation();
  if (last_ && (place - *last_).norm() < spacing_) return false;
  last_ = place;
  return true;
}

}  // namespace segdf

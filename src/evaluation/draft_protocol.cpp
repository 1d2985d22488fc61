// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/draft_protocol.hpp"

#include <algorithm>
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
  bool shows(const Eigen::Vector3f& point) const {
    return grid_.hasWithin(point, DraftProtocol::kCoAppearance);
  }

 private:
  std::vector<Eigen::Vector3f> centroids_;
  PointGrid grid_;
};

DraftScores compare(const VoxelMap& truth, const VoxelMap& dynamic, const VoxelMap& estimate) {
  DraftScores scores;
  const auto note = [&scores](const Eigen::Vector3f& point, MapVerdict verdict) {
    scores.points.push_back(point);
    scores.verdicts.push_back(verdict);
  };
  for (const Eigen::Vector3f& point : estimate.centroids()) {
    const bool there = truth.shows(point);
    ++(there ? scores.true_positive : scores.false_positive);
    note(point, there ? MapVerdict::kTruePositive : MapVerdict::kFalsePositive);
  }
  for (const Eigen::Vector3f& point : truth.centroids()) {
    if (estimate.shows(point)) continue;
    ++scores.false_negative;
    note(point, MapVerdict::kFalseNegative);
  }
  for (const Eigen::Vector3f& point : dynamic.centroids()) {
    scores.rejected_dynamic.count(!estimate.shows(point));
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
  return compare(VoxelMap(static_), VoxelMap(dynamic_), VoxelMap(estimate_));
}

DraftScores DraftProtocol::score(const std::vector<Eigen::Vector3f>& map) const {
  const VoxelMap truth(static_);
  const VoxelMap dynamic(dynamic_);
  std::vector<Eigen::Vector3f> scored = voxelCentroids(map, kVoxel);
  const VoxelMap unscored(unscored_);
  scored.erase(std::remove_if(scored.begin(), scored.end(),
                              [&](const Eigen::Vector3f& point) {
                                return !truth.shows(point) && unscored.shows(point) &&
                                       !dynamic.shows(point);
                              }),
               scored.end());
  return compare(truth, dynamic, VoxelMap(scored));
}

bool SpacedScans::pick(const Pose& pose) {
  const Eigen::Vector3d place = pose.translation();
  if (last_ && (place - *last_).norm() < spacing_) return false;
  last_ = place;
  return true;
}

}  // namespace segdf

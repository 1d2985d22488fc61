// SPDX-License-Identifier: BSD-3-Clause
#include "scan_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "segdf/core/quantile.hpp"
#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/point_grid.hpp"
#include "segdf/segmentation/ring_recovery.hpp"

namespace segdf::apps {

namespace {

namespace sk = semantic_kitti;

constexpr double kTurn = 2.0 * 3.14159265358979323846;
constexpr double kNearby = 30.0;       // metres: neighbours are sought for points within
constexpr double kNeighbour = 1.0;     // metres: farther is no neighbour
constexpr std::size_t kThinning = 10;  // every so many points look for a neighbour
// Classes whose intensity is compared: of things that look alike everywhere.
constexpr std::array<std::pair<std::uint16_t, const char*>, 6> kClasses{{{10, "car"},
                                                                         {40, "road"},
                                                                         {48, "sidewalk"},
                                                                         {50, "building"},
                                                                         {70, "vegetation"},
                                                                         {72, "terrain"}}};

double rangeOf(const Point& point) { return point.position().cast<double>().norm(); }

std::optional<double> quantileOf(std::vector<double> values, double share) {
  if (values.empty()) return std::nullopt;
  return quantile(std::move(values), share);
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double azimuthStep(const Point& a, const Point& b) {
  const double before = std::atan2(static_cast<double>(a.y), static_cast<double>(a.x));
  const double after = std::atan2(static_cast<double>(b.y), static_cast<double>(b.x));
  return std::abs(std::remainder(after - before, kTurn));
}

}  // namespace

std::optional<double> ScanStatistics::Mean::value() const {
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

void ScanStatistics::add(const FrameResult& frame, const std::vector<std::uint32_t>& truth) {
  points_.add(static_cast<double>(frame.scan.points.size()));
  addRings(frame.scan.points);
  addPoints(frame, truth);
  addClusters(frame);
  addNeighbours(frame, truth);
  addLooks(frame, truth);
}

/// A pulse without return leaves a gap of twice the usual step in its ring.
void ScanStatistics::addRings(const std::vector<Point>& points) {
  std::vector<Point> ringed = points;
  if (ringed.empty() || (ringed.front().ring < 0 && !recoverRings(ringed))) return;
  std::map<std::int16_t, std::size_t> counts;
  std::vector<double> steps;
  for (std::size_t i = 0; i < ringed.size(); ++i) {
    ++counts[ringed[i].ring];
    if (i > 0 && ringed[i].ring == ringed[i - 1].ring) {
      steps.push_back(azimuthStep(ringed[i - 1], ringed[i]));
    }
  }
  const double step = quantileOf(std::move(steps), 0.5).value_or(kTurn);
  returns_.part += points.size();
  returns_.whole += static_cast<std::size_t>(static_cast<double>(counts.size()) * kTurn / step);
  std::size_t ring = 0;
  for (const auto& [id, count] : counts) {
    ring_points_[kRingGroups * ring++ / counts.size()].add(static_cast<double>(count));
  }
}

void ScanStatistics::addPoints(const FrameResult& frame, const std::vector<std::uint32_t>& truth) {
  for (std::size_t i = 0; i < frame.scan.points.size(); ++i) {
    const Point& point = frame.scan.points[i];
    const auto limit = std::upper_bound(kRanges.begin() + 1, kRanges.end() - 1, rangeOf(point));
    const auto band = static_cast<std::size_t>(limit - kRanges.begin()) - 1;
    for (std::size_t k = 0; k < kRangeBands; ++k) by_range_[k].count(k == band);
    ground_.count(frame.labels[i].state == PointState::kGround);
    if (truth.empty() || sk::isIgnored(sk::classOf(truth[i]))) continue;
    const std::uint16_t semantic_class = sk::classOf(truth[i]);
    truth_ground_.count(sk::isGround(semantic_class));
    intensity_[{semantic_class, band}].add(static_cast<double>(point.intensity));
  }
}

void ScanStatistics::addClusters(const FrameResult& frame) {
  clusters_.add(static_cast<double>(frame.instances.size()));
  for (const InstanceObservation& instance : frame.instances) {
    cluster_points_.push_back(static_cast<double>(instance.points));
    cluster_lengths_.push_back(instance.size.x());
  }
}

/// Of what stands: where something moves, scans do not fit each other.
void ScanStatistics::addNeighbours(const FrameResult& frame,
                                   const std::vector<std::uint32_t>& truth) {
  std::vector<Eigen::Vector3f> standing;
  for (std::size_t i = 0; i < frame.scan.points.size(); ++i) {
    const PointState state = frame.labels[i].state;
    const bool moving = !truth.empty() && sk::isMoving(sk::classOf(truth[i]));
    const bool up = !moving && state != PointState::kGround && state != PointState::kUnjudged;
    if (up && rangeOf(frame.scan.points[i]) < kNearby) {
      standing.push_back(frame.scan.points[i].position());
    }
  }
  if (!last_.empty() && !standing.empty()) {
    const PointGrid grid(standing, kNeighbour / 2.0);
    const Pose now_T_last = frame.scan.pose.inverse() * last_pose_;
    for (std::size_t i = 0; i < last_.size(); i += kThinning) {
      const Eigen::Vector3d moved = now_T_last * last_[i].cast<double>();
      const auto neighbour = grid.nearest(moved.cast<float>(), kNeighbour);
      if (neighbour) neighbour_distances_.push_back(neighbour->distance);
    }
  }
  last_ = std::move(standing);
  last_pose_ = frame.scan.pose;
}

/// Of instances of which no point moves by the truth; without truth, of those that the filter
/// keeps.
void ScanStatistics::addLooks(const FrameResult& frame, const std::vector<std::uint32_t>& truth) {
  std::set<std::uint32_t> moving;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (sk::isMoving(sk::classOf(truth[i]))) moving.insert(frame.labels[i].instance);
  }
  for (const InstanceObservation& instance : frame.instances) {
    const bool stands = truth.empty() ? !instance.dynamic : moving.count(instance.id) == 0;
    if (!stands) continue;
    for (const Look& look : instance.looks) {
      free_shares_.push_back(static_cast<double>(look.free) / static_cast<double>(look.seen));
    }
  }
}

std::vector<std::pair<std::string, std::optional<double>>> ScanStatistics::rows() const {
  std::vector<std::pair<std::string, std::optional<double>>> rows;
  const auto add = [&rows](const std::string& name, std::optional<double> value) {
    rows.emplace_back(name, value);
  };
  const auto metres = [](double value) { return std::to_string(static_cast<int>(value)); };
  add("points a scan", points_.value());
  for (std::size_t k = 0; k < kRingGroups; ++k) {
    add("points a ring, quarter " + std::to_string(k + 1), ring_points_[k].value());
  }
  const std::optional<double> returned = returns_.percent();
  add("pulses without return, %", returned ? std::optional(100.0 - *returned) : std::nullopt);
  for (std::size_t k = 0; k < kRangeBands; ++k) {
    const bool last = k + 1 == kRangeBands;
    add("points from " + metres(kRanges[k]) +
            (last ? " m on, %" : " to " + metres(kRanges[k + 1]) + " m, %"),
        by_range_[k].percent());
  }
  add("ground by the filter, %", ground_.percent());
  add("ground by the labels, %", truth_ground_.percent());
  add("clusters a scan", clusters_.value());
  add("points a cluster, median", quantileOf(cluster_points_, 0.5));
  add("points a cluster, 90 % quantile", quantileOf(cluster_points_, 0.9));
  add("length of a cluster, median, m", quantileOf(cluster_lengths_, 0.5));
  add("neighbour in the next scan, median, m", quantileOf(neighbour_distances_, 0.5));
  add("neighbour in the next scan, 90 % quantile, m", quantileOf(neighbour_distances_, 0.9));
  add("F of what stands, mean", mean(free_shares_));
  add("F of what stands, 90 % quantile", quantileOf(free_shares_, 0.9));
  add("F of what stands, 99 % quantile", quantileOf(free_shares_, 0.99));
  for (const auto& [semantic_class, name] : kClasses) {
    for (std::size_t k = 1; k + 2 < kRangeBands; ++k) {
      const auto found = intensity_.find({semantic_class, k});
      add(std::string("intensity of ") + name + ", " + metres(kRanges[k]) + " to " +
              metres(kRanges[k + 1]) + " m",
          found == intensity_.end() ? std::nullopt : found->second.value());
    }
  }
  return rows;
}

}  // namespace segdf::apps

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/scan_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "segdf/core/quantile.hpp"
#include "segdf/dynamics/pose_misfit.hpp"
#include "segdf/io/config_yaml.hpp"
#include "segdf/ros/cloud_fields.hpp"
#include "segdf/segmentation/segmenter.hpp"

namespace segdf {
namespace {

// A VLP-16, the sparsest of the known sensors, returns 15,000 and more with half of its rays.
constexpr double kFewPoints = 2000.0;
constexpr double kManyNan = 0.9;  // share; even an open field returns more than a tenth of the rays
// The points lie around the sensor: farther than this from the origin, a scan of the other form
// lies clearly elsewhere.
constexpr double kFar = 20.0;  // metres
constexpr double kNearer = 1.0 / 3.0;

/// Middle of the points, by coordinate. NaN if there are none.
Eigen::Vector3d middleOf(const Scan& scan) {
  std::array<std::vector<double>, 3> values;
  for (const Point& point : scan.points) {
    if (!isFinite(point)) continue;
    values[0].push_back(static_cast<double>(point.x));
    values[1].push_back(static_cast<double>(point.y));
    values[2].push_back(static_cast<double>(point.z));
  }
  return {medianOf(values[0]), medianOf(values[1]), medianOf(values[2])};
}

std::string percent(std::size_t part, std::size_t whole) {
  return fixed(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1) + " %";
}

}  // namespace

void ScanCheck::add(Scan scan, bool follows) {
  ++scans_;
  count(scan);
  if (!isValidPose(scan.pose)) {
    last_.reset();
    return;
  }
  compareForms(scan);
  measureMisfit(std::move(scan), follows);
}

void ScanCheck::count(const Scan& scan) {
  std::size_t finite = 0;
  bool rings = false;
  for (const Point& point : scan.points) {
    rings = rings || point.ring >= 0;
    if (!isFinite(point)) continue;
    if (!std::isfinite(point.intensity)) ++odd_intensities_;
    const bool first = finite_points_ + finite == 0;
    intensity_min_ = first ? point.intensity : std::fmin(intensity_min_, point.intensity);
    intensity_max_ = first ? point.intensity : std::fmax(intensity_max_, point.intensity);
    ++finite;
  }
  points_ += scan.points.size();
  finite_points_ += finite;
  points_of_scan_.push_back(static_cast<double>(finite));
  without_points_ += finite == 0 ? 1 : 0;
  without_rings_ += rings ? 0 : 1;
  if (finite > 0 && !sensor_) {
    sensor_ = recogniseSensor(scan);
    config_ = sensorConfig(sensor_->name);
  }
}

/// Would the points lie around the sensor if the clouds were of the other form?
void ScanCheck::compareForms(const Scan& scan) {
  const Eigen::Vector3d middle = middleOf(scan);
  if (!middle.allFinite() || scan.pose.translation().norm() < kFar) return;
  const Pose to_other = registered_ ? scan.pose : scan.pose.inverse();
  ++far_scans_;
  other_form_ += (to_other * middle).norm() < kNearer * middle.norm() ? 1 : 0;
}

void ScanCheck::measureMisfit(Scan scan, bool follows) {
  auto frame = std::make_unique<KeyFrame>();
  frame->scan = std::move(scan);
  frame->seg = segmentScan(frame->scan, config_, 1, frame->times);
  if (follows && last_) {
    const CurvedGrid grid(config_.cvi, config_.input.min_range);
    const double misfit = poseMisfit(*frame, *last_, grid);
    if (!std::isnan(misfit)) misfits_.push_back(misfit);
  }
  last_ = std::move(frame);
}

void ScanCheck::finish(BagReport& report) const {
  if (scans_ == 0) return;
  reportPoints(report);
  if (finite_points_ == 0) return;
  reportIntensity(report);
  reportSensor(report);
  reportForm(report);
  reportMisfit(report);
}

void ScanCheck::reportPoints(BagReport& report) const {
  const double median = medianOf(points_of_scan_);
  report.facts.emplace_back(
      "points", fixed(median, 0) + " a scan (median of " + std::to_string(scans_) +
                    " scans looked into), " +
                    percent(points_ - finite_points_, std::max(points_, std::size_t{1})) + " NaN");
  if (finite_points_ == 0) {
    report.errors.emplace_back("no scan that was looked into has a point with finite coordinates");
    return;
  }
  if (without_points_ > 0) {
    report.warnings.push_back(
        std::to_string(without_points_) + " of " + std::to_string(scans_) +
        " scans looked into have no point with finite coordinates: they are left out");
  }
  if (static_cast<double>(points_ - finite_points_) > kManyNan * static_cast<double>(points_)) {
    report.warnings.push_back(percent(points_ - finite_points_, points_) +
                              " of the points are NaN: too few returns to tell objects apart");
  } else if (median < kFewPoints) {
    report.warnings.push_back("only " + fixed(median, 0) +
                              " points a scan (median): thinned, or features only; "
                              "segdf needs the full sweep");
  }
}

void ScanCheck::reportIntensity(BagReport& report) const {
  report.facts.emplace_back("intensity", fixed(static_cast<double>(intensity_min_), 2) + " to " +
                                             fixed(static_cast<double>(intensity_max_), 2));
  if (odd_intensities_ > 0) {
    report.warnings.push_back(percent(odd_intensities_, finite_points_) +
                              " of the intensities are NaN or infinite; correct the node that "
                              "publishes the clouds");
  }
  if (intensity_min_ == intensity_max_) {
    report.warnings.push_back("intensity is " + fixed(static_cast<double>(intensity_min_), 2) +
                              " in every point: touching objects of different material cannot be "
                              "told apart; publish the sensor's intensity");
  }
}

void ScanCheck::reportSensor(BagReport& report) const {
  const std::string seen = std::to_string(sensor_->beams) + " lasers from " +
                           fixed(sensor_->elevation_min, 1) + " to " +
                           fixed(sensor_->elevation_max, 1) + " deg";
  const char* rings = without_rings_ == 0 ? "known or recovered from the order of the points"
                                          : "not known: found by elevation";
  report.facts.emplace_back("sensor", sensor_->name + " (" + seen + "), rings " + rings);
  if (sensor_->certain) return;
  report.warnings.push_back("unknown sensor (" + seen + "), " + sensor_->name +
                            " is the nearest known; choose with --sensor or describe it with "
                            "--config (docs/bags.md)");
}

void ScanCheck::reportForm(BagReport& report) const {
  if (far_scans_ == 0 || 2 * other_form_ <= far_scans_) return;
  report.errors.emplace_back(
      registered_
          ? "clouds carry the frame of the odometry, but their points lie around the origin and "
            "not around the pose: they are seen from the sensor; give them its frame_id"
          : "clouds carry another frame than the odometry, but their points lie around the pose "
            "and not around the origin: they are registered; give them the frame_id of the "
            "odometry");
}

void ScanCheck::reportMisfit(BagReport& report) const {
  if (misfits_.empty()) return;
  const double misfit = medianOf(misfits_);
  const double limit = config_.input.max_misfit;
  report.facts.emplace_back("misfit", fixed(misfit, 3) +
                                          " m between consecutive scans under "
                                          "their poses (median of " +
                                          std::to_string(misfits_.size()) + ")");
  if (misfit <= limit) return;
  report.warnings.push_back("poses do not fit the scans: consecutive scans disagree by " +
                            fixed(misfit, 3) +
                            " m (median; more than input.max_misfit = " + fixed(limit, 3) +
                            " m); check that poses belong to these scans and to the lidar, not to "
                            "camera or base");
}

std::string describeFields(const sensor_msgs::PointCloud2& cloud) {
  std::string text;
  const auto& fields = cloud.fields;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const bool new_type = k == 0 || fields[k].datatype != fields[k - 1].datatype;
    if (k > 0) text += new_type ? " (" + datatypeName(fields[k - 1].datatype) + "), " : " ";
    text += fields[k].name;
  }
  return text.empty() ? "none" : text + " (" + datatypeName(fields.back().datatype) + ")";
}

}  // namespace segdf

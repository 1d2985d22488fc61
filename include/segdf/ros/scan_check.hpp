// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <sensor_msgs/PointCloud2.h>

#include "segdf/core/config.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/ros/bag_report.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

namespace segdf {

/// Looks into scans, one by one: points and their values, sensor, how well consecutive poses fit.
class ScanCheck {
 public:
  /// @param registered the clouds come in the odometry frame
  explicit ScanCheck(bool registered) : registered_(registered) {}

  /// @param scan as toScan() gives it
  /// @param follows it is the next scan after the one that was added last
  void add(Scan scan, bool follows);

  /// Adds what was found to the report.
  void finish(BagReport& report) const;

 private:
  void count(const Scan& scan);
  void compareForms(const Scan& scan);
  void measureMisfit(Scan scan, bool follows);
  void reportPoints(BagReport& report) const;
  void reportIntensity(BagReport& report) const;
  void reportSensor(BagReport& report) const;
  void reportForm(BagReport& report) const;
  void reportMisfit(BagReport& report) const;

  bool registered_;
  std::size_t scans_ = 0;
  std::size_t without_points_ = 0;
  std::size_t without_rings_ = 0;
  std::size_t points_ = 0;
  std::size_t finite_points_ = 0;
  std::size_t odd_intensities_ = 0;  ///< NaN or infinite
  std::vector<double> points_of_scan_;
  float intensity_min_ = 0.0F;
  float intensity_max_ = 0.0F;
  std::size_t far_scans_ = 0;   ///< far enough from the origin to tell one form from the other
  std::size_t other_form_ = 0;  ///< of these, those that look like the other form
  std::optional<SensorGuess> sensor_;
  Config config_;
  std::unique_ptr<KeyFrame> last_;
  std::vector<double> misfits_;
};

/// "x y z intensity (float32), ring (uint16)".
std::string describeFields(const sensor_msgs::PointCloud2& cloud);

}  // namespace segdf

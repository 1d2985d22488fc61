// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <std_srvs/Trigger.h>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <segdf/FrameReport.h>

/// What the tests that run under rostest share: the node /segdf seen from outside.
namespace segdf::test {

using Labels = std::vector<std::uint32_t>;

constexpr std::uint32_t kQueueSize = 1000;  // more than scans in a bag: the tests lose nothing
constexpr double kPatience = 60.0;          // seconds for any one thing to happen

/// As SemanticKITTI has it: class below, instance above, 0 for instances that do not fit.
inline Labels labelsOf(const sensor_msgs::PointCloud2& cloud) {
  Labels labels;
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> label(cloud, "label");
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> instance(cloud, "instance");
  for (; label != label.end(); ++label, ++instance) {
    labels.push_back((*instance <= 0xFFFF ? *instance << 16U : 0U) | *label);
  }
  return labels;
}

inline Labels readLabels(const std::filesystem::path& file) {
  Labels labels(std::filesystem::file_size(file) / sizeof(std::uint32_t));
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(labels.data()),
            static_cast<std::streamsize>(labels.size() * sizeof(std::uint32_t)));
  return labels;
}

inline std::vector<std::filesystem::path> labelFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Spins until `done` holds. @return whether it did in time
template <class Done>
bool spinUntil(const Done& done, double patience = kPatience) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(patience);
  while (!done()) {
    if (ros::WallTime::now() > end) return false;
    ros::spinOnce();
    ros::WallDuration(0.01).sleep();
  }
  return true;
}

/// Keeps what the node says of each frame.
class NodeClient {
 public:
  NodeClient() {
    labelled_ = node_.subscribe<sensor_msgs::PointCloud2>(
        "/segdf/labelled_cloud", kQueueSize, [this](const sensor_msgs::PointCloud2ConstPtr& cloud) {
          frames.push_back(labelsOf(*cloud));
        });
    reports_ = node_.subscribe<FrameReport>(
        "/segdf/frame_report", kQueueSize,
        [this](const FrameReportConstPtr& report) { reports.push_back(*report); });
    diagnostics_ = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", kQueueSize, &NodeClient::readDiagnostics, this);
  }

  bool isConnected() const {
    return labelled_.getNumPublishers() > 0 && reports_.getNumPublishers() > 0;
  }

  /// The node has its own connections: what a test has heard may still be on the way to it.
  bool waitUntilReceived(std::size_t clouds) const {
    return spinUntil([&] { return clouds_received_ == std::to_string(clouds); });
  }

  /// @return the node's line
  static std::string flush() {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::call("/segdf/flush", trigger));
    EXPECT_TRUE(trigger.response.success) << trigger.response.message;
    return trigger.response.message;
  }

  std::vector<Labels> frames;
  std::vector<FrameReport> reports;

 private:
  void readDiagnostics(const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
    for (const auto& status : array->status) {
      for (const auto& pair : status.values) {
        if (pair.key == "clouds received") clouds_received_ = pair.value;
      }
    }
  }

  std::string clouds_received_;
  ros::NodeHandle node_;
  ros::Subscriber labelled_;
  ros::Subscriber reports_;
  ros::Subscriber diagnostics_;
};

/// received = everything that became of it.
inline void expectAccounted(const FrameReport& report) {
  EXPECT_EQ(report.clouds_received, report.scans_processed + report.scans_waiting +
                                        report.scans_dropped + report.scans_unusable +
                                        report.clouds_unmatched + report.clouds_waiting);
}

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>

#include "segdf/nodelets/drive_recorder.hpp"
#include "segdf/nodelets/ledger.hpp"
#include "segdf/nodelets/live_filter.hpp"
#include "segdf/nodelets/output_topics.hpp"
#include "segdf/nodelets/sensor_mount.hpp"
#include "segdf/nodelets/tally.hpp"
#include "segdf/ros/parameters.hpp"

namespace segdf {

/// All that happens to a pair in the worker: message to scan, filter, topics, files. For the
/// worker's thread only, but for snapshot().
class FilterStage {
 public:
  /// @param name of the logger @param cloud_topic named in messages
  /// @param mount may be null: clouds are the odometry's own
  /// @param ledger, outputs outlive the stage
  /// @throws what wrong parameters throw; IoError if output_dir cannot be written
  FilterStage(const PrivateParameters& parameters,
              std::string name,
              std::string cloud_topic,
              std::unique_ptr<SensorMount> mount,
              Ledger& ledger,
              OutputTopics& outputs);

  /// Filters a pair and publishes the frames that leave the window. Never throws for bad data.
  /// @param waited seconds, for the ledger
  void handle(const sensor_msgs::PointCloud2ConstPtr& cloud,
              const nav_msgs::Odometry& odometry,
              double waited);

  /// Decides and publishes what is in the window, then the map; the session's files appear.
  /// @return one line for the user
  std::string flush();

  /// flush(), then starts anew. @return one line for the user
  std::string reset(bool keep_map);

  void publishMap();

  /// Map and instances as they are, from any thread.
  MapSnapshot snapshot() const { return filter_.snapshot(); }

 private:
  void take(Scan scan, const std_msgs::Header& header);
  void publish(const std::vector<FrameResult>& frames);
  void record(const FrameResult& frame);
  std::string finishFiles();
  void check(const FrameResult& frame);
  void tell(const std::string& kind, const std::string& what);

  NodeParameters parameters_;
  std::string name_;
  std::string cloud_topic_;
  std::unique_ptr<SensorMount> mount_;
  Ledger& ledger_;
  OutputTopics& outputs_;
  LiveFilter filter_;
  std::unique_ptr<DriveRecorder> recorder_;
  bool recording_failed_ = false;  ///< in this session
  std_msgs::Header header_;        ///< of the odometry of the latest scan
  Tally troubles_;
};

}  // namespace segdf

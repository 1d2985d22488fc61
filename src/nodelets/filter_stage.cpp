// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/filter_stage.hpp"

#include <utility>

#include <ros/console.h>

#include "segdf/core/stopwatch.hpp"
#include "segdf/ros/conversions.hpp"

namespace segdf {

FilterStage::FilterStage(const PrivateParameters& parameters,
                         std::string name,
                         std::string cloud_topic,
                         std::unique_ptr<SensorMount> mount,
                         Ledger& ledger,
                         OutputTopics& outputs)
    : parameters_(parameters.node),
      name_(std::move(name)),
      cloud_topic_(std::move(cloud_topic)),
      mount_(std::move(mount)),
      ledger_(ledger),
      outputs_(outputs),
      filter_(
          parameters.node.sensor,
          parameters.node.threads,
          [yaml = parameters.config_yaml](const std::string& sensor) {
            return makeConfig(sensor, yaml);
          },
          [this](const std::string& line) { ROS_INFO_STREAM_NAMED(name_, line); }) {
  if (!parameters_.output_dir.empty()) {
    recorder_ = std::make_unique<DriveRecorder>(parameters_.output_dir);
  }
}

void FilterStage::handle(const sensor_msgs::PointCloud2ConstPtr& cloud,
                         const nav_msgs::Odometry& odometry,
                         double waited) {
  const Stopwatch watch;
  try {
    if (mount_) {
      const SensorMount::Seen seen = mount_->apply(cloud, odometry);
      take(toScan(*seen.cloud, seen.odometry, cloud_topic_), odometry.header);
    } else {
      take(toScan(*cloud, odometry, cloud_topic_), odometry.header);
    }
  } catch (const std::exception& error) {
    ledger_.change([](Counts& counts) { ++counts.unusable; });
    tell("unusable scan", error.what());
  }
  ledger_.change([taken = watch.seconds(), waited](Counts& counts) {
    counts.filtering.add(taken);
    counts.waiting.add(waited);
  });
}

void FilterStage::take(Scan scan, const std_msgs::Header& header) {
  const bool other_frame = !header_.frame_id.empty() && header.frame_id != header_.frame_id;
  if (filter_.isBehind(scan) || other_frame) {
    tell("restart", other_frame ? "the odometry frame has changed: starting anew"
                                : "time has gone backwards: starting anew");
    reset(false);
    ledger_.change([](Counts& counts) { ++counts.time_resets; });
  }
  header_ = header;
  const std::vector<FrameResult> frames = filter_.process(std::move(scan));
  ledger_.change([](Counts& counts) { ++counts.processed; });
  publish(frames);
}

std::string FilterStage::flush() {
  publish(filter_.flush());
  publishMap();
  const std::string files = finishFiles();
  const Counts counts = ledger_.counts();
  return std::to_string(counts.frames) + " frames published, the map has " +
         std::to_string(filter_.map().size()) + " points" + files + "; " + toText(counts);
}

std::string FilterStage::reset(bool keep_map) {
  const std::string flushed = flush();
  if (!keep_map) filter_.restart();
  return (keep_map ? "window cleared, map kept: " : "window and map cleared: ") + flushed;
}

void FilterStage::publish(const std::vector<FrameResult>& frames) {
  for (const FrameResult& frame : frames) {
    ledger_.change([&frame](Counts& counts) {
      ++counts.frames;
      counts.jump_resets += frame.after_jump ? 1 : 0;
    });
    const Counts counts = ledger_.counts();
    outputs_.publish(frame, header_.frame_id, counts);
    record(frame);
    check(frame);
    if (outputs_.isMapDue(counts.frames)) publishMap();
  }
}

void FilterStage::publishMap() {
  if (!filter_.map().empty()) outputs_.publishMap(filter_.map(), header_);
}

void FilterStage::record(const FrameResult& frame) {
  if (!recorder_ || recording_failed_) return;
  try {
    if (!recorder_->isOpen()) {
      recorder_->open(*filter_.config(), {"topic " + cloud_topic_, filter_.sensor(),
                                          nameOf(filter_.config()->df.mode, DynamicConfig::kModes),
                                          parameters_.threads});
    }
    recorder_->add(frame);
  } catch (const std::exception& error) {
    recording_failed_ = true;
    ROS_ERROR_STREAM_NAMED(name_, error.what());
  }
}

std::string FilterStage::finishFiles() {
  recording_failed_ = false;
  if (!recorder_) return "";
  try {
    const std::string folder = recorder_->finish();
    return folder.empty() ? "" : ", results are in " + folder;
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM_NAMED(name_, error.what());
    return std::string(", but: ") + error.what();
  }
}

void FilterStage::check(const FrameResult& frame) {
  if (frame.status != FrameStatus::kMapped && frame.status != FrameStatus::kNotKeyFrame) {
    tell("scan not mapped, " + toString(frame.status),
         "stamp " + std::to_string(frame.scan.stampSeconds()) + " s");
  }
  if (frame.after_jump) {
    tell("pose jumped",
         "loop closure? What came before is decided, the map stays, and the window "
         "starts anew (input.max_jump)");
  }
  if (filter_.isMisfit(frame)) {
    tell("pose does not fit the scan",
         "median misfit " + std::to_string(frame.pose_misfit) + " m to the key frame before");
  }
}

void FilterStage::tell(const std::string& kind, const std::string& what) {
  if (!troubles_.count(kind)) return;
  ROS_WARN_STREAM_NAMED(name_, kind << " (" << troubles_.of(kind) << " so far): " << what);
}

}  // namespace segdf

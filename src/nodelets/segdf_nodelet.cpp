// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/segdf_nodelet.hpp"

#include <future>
#include <utility>

#include <pluginlib/class_list_macros.hpp>
#include <ros/param.h>

#include "segdf/io/config_yaml.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/topic_choice.hpp"

namespace segdf {
namespace {

constexpr double kWatchPeriod = 5.0;  // seconds
// Messages that may wait for a ROS thread, or for their other half. These threads do next to
// nothing, so that this is never reached; the queue that can run full is the worker's, which
// counts.
constexpr std::uint32_t kIncoming = 100;

/// Wrong parameters are told at the start, not when the first scan has shown the sensor.
void checkParameters(const PrivateParameters& parameters) {
  const std::string& sensor = parameters.node.sensor;
  const bool known = sensor != NodeParameters::kAutoSensor;
  makeConfig(known ? sensor : knownSensors().front(), parameters.config_yaml);
}

}  // namespace

void SegdfNodelet::onInit() {
  try {
    start();
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM(error.what());
    throw;
  }
}

void SegdfNodelet::start() {
  ros::NodeHandle& node = getPrivateNodeHandle();
  XmlRpc::XmlRpcValue tree;
  ros::param::get(node.getNamespace(), tree);
  const PrivateParameters parameters = splitParameters(tree);
  checkParameters(parameters);
  parameters_ = parameters.node;
  cloud_topic_ = getNodeHandle().resolveName("cloud");
  odometry_topic_ = getNodeHandle().resolveName("odometry");
  refuseFeatureCloud(cloud_topic_);
  filter_ = std::make_unique<LiveFilter>(
      parameters_.sensor, parameters_.threads,
      [yaml = parameters.config_yaml](const std::string& sensor) {
        return makeConfig(sensor, yaml);
      },
      [this](const std::string& line) { NODELET_INFO_STREAM(line); });
  outputs_ = std::make_unique<OutputTopics>(node, parameters_.queue_size,
                                            [this] { worker_->tryPost([this] { publishMap(); }); });
  worker_ = std::make_unique<Worker>(parameters_.queue_size);
  subscribe();
}

void SegdfNodelet::subscribe() {
  pairs_ = std::make_unique<Synchroniser>(
      kIncoming, [this](const sensor_msgs::PointCloud2ConstPtr& cloud,
                        const nav_msgs::OdometryConstPtr& odometry) { enqueue(cloud, odometry); });
  ros::NodeHandle& node = getNodeHandle();
  odometry_subscriber_ =
      node.subscribe("odometry", kIncoming, &Synchroniser::addOdometry, pairs_.get());
  cloud_subscriber_ = node.subscribe("cloud", kIncoming, &Synchroniser::addCloud, pairs_.get());
  watch_timer_ = node.createWallTimer(ros::WallDuration(kWatchPeriod),
                                      [this](const ros::WallTimerEvent&) { watch(); });
  // It waits for the worker, and must not keep the messages waiting: hence the other queue.
  flush_service_ = getMTPrivateNodeHandle().advertiseService("flush", &SegdfNodelet::onFlush, this);
}

void SegdfNodelet::enqueue(const sensor_msgs::PointCloud2ConstPtr& cloud,
                           const nav_msgs::OdometryConstPtr& odometry) {
  const bool taken = worker_->tryPost([this, cloud, odometry] { handle(*cloud, *odometry); });
  if (!taken) ++overflows_;
}

void SegdfNodelet::watch() {
  const Synchroniser::Counts& counts = pairs_->counts();
  watchForSilence(counts);
  if (counts.unmatched > seen_.unmatched) {
    NODELET_WARN("%zu of %zu clouds had no odometry message of the same stamp and were left out",
                 counts.unmatched, counts.clouds);
  }
  if (overflows_ > overflows_seen_) {
    NODELET_WARN(
        "%zu of %zu scans were dropped because %d were waiting: play the bag slower, give more "
        "threads, or raise queue_size",
        overflows_, counts.pairs, parameters_.queue_size);
  }
  seen_ = counts;
  overflows_seen_ = overflows_;
}

void SegdfNodelet::watchForSilence(const Synchroniser::Counts& counts) {
  const bool silent = counts.pairs == seen_.pairs;
  if (silent && !silence_told_ && counts.pairs == 0) {
    NODELET_WARN(
        "no cloud and odometry message of the same stamp for %.0f s: %zu clouds on '%s', %zu "
        "odometry messages on '%s' so far; check the two topics",
        kWatchPeriod, counts.clouds, cloud_topic_.c_str(), counts.poses, odometry_topic_.c_str());
  } else if (silent && !silence_told_) {
    NODELET_INFO("no new scan for %.0f s, %zu so far; the service flush decides the last ones",
                 kWatchPeriod, counts.pairs);
  }
  silence_told_ = silent;
}

bool SegdfNodelet::onFlush(std_srvs::Trigger::Request& /*request*/,
                           std_srvs::Trigger::Response& response) {
  auto task = std::make_shared<std::packaged_task<std::string()>>([this] {
    finishSession();
    return std::to_string(frames_) + " frames published, the map has " +
           std::to_string(filter_->map().size()) + " points";
  });
  std::future<std::string> answer = task->get_future();
  worker_->post([task] { (*task)(); });
  response.message = answer.get();
  response.success = 1;
  return true;
}

void SegdfNodelet::handle(const sensor_msgs::PointCloud2& cloud,
                          const nav_msgs::Odometry& odometry) {
  try {
    take(toScan(cloud, odometry, cloud_topic_), odometry.header);
  } catch (const std::exception& error) {
    tell("unusable scan", error.what());
  }
}

void SegdfNodelet::take(Scan scan, const std_msgs::Header& header) {
  const bool other_frame = frames_ > 0 && header.frame_id != header_.frame_id;
  if (filter_->isBehind(scan) || other_frame) {
    tell("restart", other_frame ? "the odometry frame has changed: starting anew"
                                : "time has gone backwards: starting anew");
    finishSession();
    filter_->restart();
  }
  header_ = header;
  publish(filter_->process(std::move(scan)));
}

void SegdfNodelet::finishSession() {
  publish(filter_->flush());
  publishMap();
}

void SegdfNodelet::publish(const std::vector<FrameResult>& frames) {
  for (const FrameResult& frame : frames) {
    outputs_->publish(frame, header_.frame_id);
    check(frame);
    const bool due = ++frames_ % static_cast<std::size_t>(parameters_.map_every) == 0;
    if (due && outputs_->mapHasViewers()) publishMap();
  }
}

void SegdfNodelet::publishMap() {
  if (!filter_->map().empty()) outputs_->publishMap(filter_->map(), header_);
}

void SegdfNodelet::check(const FrameResult& frame) {
  if (frame.status != FrameStatus::kMapped && frame.status != FrameStatus::kNotKeyFrame) {
    tell("scan not mapped, " + toString(frame.status),
         "stamp " + std::to_string(frame.scan.stampSeconds()) + " s");
  }
  if (filter_->isMisfit(frame)) {
    tell("pose does not fit the scan",
         "median misfit " + std::to_string(frame.pose_misfit) + " m to the key frame before");
  }
}

void SegdfNodelet::tell(const std::string& kind, const std::string& what) {
  if (!troubles_.count(kind)) return;
  NODELET_WARN_STREAM(kind << " (" << troubles_.of(kind) << " so far): " << what);
}

}  // namespace segdf

PLUGINLIB_EXPORT_CLASS(segdf::SegdfNodelet, nodelet::Nodelet)

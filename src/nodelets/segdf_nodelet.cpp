// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/segdf_nodelet.hpp"

#include <cstdint>
#include <future>
#include <utility>
#include <vector>

#include <nodelet/detail/callback_queue.h>
#include <pluginlib/class_list_macros.hpp>
#include <ros/param.h>

#include "segdf/core/stopwatch.hpp"
#include "segdf/io/config_yaml.hpp"
#include "segdf/io/map_export.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/ros/topic_choice.hpp"

namespace segdf {
namespace {

/// Wrong parameters are told at the start, not when the first scan has shown the sensor.
void checkParameters(const PrivateParameters& parameters) {
  const std::string& sensor = parameters.node.sensor;
  const bool known = sensor != NodeParameters::kAutoSensor;
  makeConfig(known ? sensor : knownSensors().front(), parameters.config_yaml);
}

PrivateParameters readParameters(const std::string& name_space) {
  XmlRpc::XmlRpcValue tree;
  ros::param::get(name_space, tree);
  PrivateParameters parameters = splitParameters(tree);
  checkParameters(parameters);
  return parameters;
}

/// Answers a service: what was done, or why it was not.
template <class Response, class Action>
void answer(Response& response, const Action& action) {
  try {
    response.message = action();
    response.success = 1;
  } catch (const std::exception& error) {
    response.message = error.what();
    response.success = 0;
  }
}

}  // namespace

SegdfNodelet::~SegdfNodelet() {
  for (ros::ServiceServer* service : {&flush_service_, &reset_service_, &save_service_}) {
    service->shutdown();
  }
  display_server_.reset();
  diagnostics_.reset();
  intake_.reset();
  if (worker_) worker_->stop();
  if (!stage_ || ledger_.counts().processed == 0) return;
  try {
    NODELET_INFO_STREAM("ends: " << stage_->flush());
  } catch (const std::exception& error) {
    NODELET_ERROR_STREAM(error.what());
  }
}

void SegdfNodelet::onInit() {
  try {
    start();
  } catch (const std::exception& error) {
    NODELET_FATAL_STREAM(error.what());
    throw;
  }
}

void SegdfNodelet::keepCallbackQueue() {
  if (auto* const queue = dynamic_cast<nodelet::detail::CallbackQueue*>(&getSTCallbackQueue())) {
    callback_queue_ = queue->shared_from_this();
  }
}

void SegdfNodelet::start() {
  keepCallbackQueue();
  ros::NodeHandle& node = getPrivateNodeHandle();
  const PrivateParameters parameters = readParameters(node.getNamespace());
  const std::string cloud_topic = getNodeHandle().resolveName("cloud");
  refuseFeatureCloud(cloud_topic);
  startTf(parameters.node);
  outputs_ = std::make_unique<OutputTopics>(node, parameters.node.queue_size);
  stage_ = std::make_unique<FilterStage>(parameters, getName(), cloud_topic,
                                         makeMount(parameters.node), ledger_, *outputs_);
  worker_ = std::make_unique<Worker>(static_cast<std::size_t>(parameters.node.queue_size));
  outputs_->offerMap(node, [this] { worker_->tryPost([this] { stage_->publishMap(); }); });
  intake_ = std::make_unique<Intake>(getNodeHandle(), parameters.node, getName(), ledger_,
                                     intakeHandlers(), tf_buffer_.get());
  diagnostics_ = std::make_unique<Diagnostics>(getNodeHandle(), node, getName(), ledger_);
  advertiseServices();
  offerDisplayOptions();
}

void SegdfNodelet::startTf(const NodeParameters& node) {
  if (!node.use_tf && node.base_frame.empty()) return;
  tf_buffer_ = std::make_unique<tf2_ros::Buffer>();
  tf_listener_ = std::make_unique<tf2_ros::TransformListener>(*tf_buffer_);
}

std::unique_ptr<SensorMount> SegdfNodelet::makeMount(const NodeParameters& node) const {
  if (!tf_buffer_) return nullptr;
  return std::make_unique<SensorMount>(*tf_buffer_, node.base_frame, node.sensor_frame);
}

Intake::Handlers SegdfNodelet::intakeHandlers() {
  return {[this](const sensor_msgs::PointCloud2ConstPtr& cloud,
                 const nav_msgs::OdometryConstPtr& odometry) {
            return worker_->tryPost([this, cloud, odometry, in_queue = Stopwatch()] {
              stage_->handle(cloud, *odometry, in_queue.seconds());
            });
          },
          [this] {
            return worker_->tryPost(
                [this] { NODELET_INFO_STREAM("no more clouds: " << stage_->flush()); });
          }};
}

void SegdfNodelet::advertiseServices() {
  ros::NodeHandle node = filtering_.handle(getPrivateNodeHandle());
  flush_service_ = node.advertiseService("flush", &SegdfNodelet::onFlush, this);
  reset_service_ = node.advertiseService("reset", &SegdfNodelet::onReset, this);
  save_service_ = saving_.handle(node).advertiseService("save_map", &SegdfNodelet::onSaveMap, this);
}

/// The server reads the same parameters again; outside their bounds they have been refused.
void SegdfNodelet::offerDisplayOptions() {
  using Server = dynamic_reconfigure::Server<DisplayConfig>;
  display_server_ = std::make_unique<Server>(getPrivateNodeHandle());
  display_server_->setCallback([this](const DisplayConfig& display, std::uint32_t /*level*/) {
    outputs_->show(display);
    worker_->tryPost([this] {
      if (outputs_->mapHasViewers()) stage_->publishMap();
    });
  });
}

/// Waits until the worker has come so far: what waits in its queue goes first.
std::string SegdfNodelet::inWorker(std::function<std::string()> work) {
  auto task = std::make_shared<std::packaged_task<std::string()>>(std::move(work));
  std::future<std::string> result = task->get_future();
  worker_->post([task] { (*task)(); });
  return result.get();
}

bool SegdfNodelet::onFlush(std_srvs::Trigger::Request& /*request*/,
                           std_srvs::Trigger::Response& response) {
  answer(response, [this] { return inWorker([this] { return stage_->flush(); }); });
  return true;
}

bool SegdfNodelet::onReset(ResetRequest& request, ResetResponse& response) {
  const bool keep_map = request.keep_map != 0;
  answer(response, [&] { return inWorker([this, keep_map] { return stage_->reset(keep_map); }); });
  return true;
}

bool SegdfNodelet::onSaveMap(SaveMapRequest& request, SaveMapResponse& response) {
  answer(response,
         [&] { return saveMap(request.destination, static_cast<double>(request.resolution)); });
  if (response.success == 0) NODELET_ERROR_STREAM("map not saved: " << response.message);
  return true;
}

/// Not in the worker, which filters on meanwhile. One at a time: the thread has no other service.
std::string SegdfNodelet::saveMap(const std::string& destination, double resolution) {
  checkExport(destination);
  const Counts counts = ledger_.counts();
  const MapSnapshot snapshot = stage_->snapshot();
  if (snapshot.points.empty()) {
    throw IoError("the map is still empty; ~flush decides the scans that wait for a verdict: " +
                  toText(counts));
  }
  const std::vector<MapPoint> points = thinned(snapshot.points, resolution);
  exportMap(destination, points, snapshot.instances);
  const std::size_t missing = counts.processed - counts.frames + counts.scansWaiting();
  return std::to_string(points.size()) + " points in " + destination + " and " +
         std::to_string(snapshot.instances.size()) + " instances in " +
         instanceFileOf(destination).string() +
         (missing == 0 ? std::string()
                       : "; " + std::to_string(missing) +
                             " scans are not in it yet: ~flush decides those in the window");
}

}  // namespace segdf

PLUGINLIB_EXPORT_CLASS(segdf::SegdfNodelet, nodelet::Nodelet)

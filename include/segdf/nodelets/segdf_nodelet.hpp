// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <boost/shared_ptr.hpp>
#include <dynamic_reconfigure/server.h>
#include <std_srvs/Trigger.h>

#include <nodelet/nodelet.h>
#include <ros/callback_queue_interface.h>
#include <ros/service_server.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <segdf/DisplayConfig.h>
#include <segdf/Reset.h>
#include <segdf/SaveMap.h>

#include "segdf/nodelets/diagnostics.hpp"
#include "segdf/nodelets/filter_stage.hpp"
#include "segdf/nodelets/intake.hpp"
#include "segdf/nodelets/ledger.hpp"
#include "segdf/nodelets/output_topics.hpp"
#include "segdf/nodelets/service_thread.hpp"
#include "segdf/nodelets/worker.hpp"
#include "segdf/ros/parameters.hpp"

namespace segdf {

/// The filter live. In: see Intake. Out, in the odometry's frame: see OutputTopics. Services
/// `~flush`, `~reset` and `~save_map`; what is shown, and how, changes by dynamic_reconfigure. What
/// each is for: docs/ros.md.
///
/// The manager's threads only pair messages and queue the pairs; one worker filters them in order,
/// so that the labels are those of the offline runner. What does not fit in the queue is counted
/// and told. Services have threads of their own.
class SegdfNodelet : public nodelet::Nodelet {
 public:
  SegdfNodelet() = default;
  /// Decides and writes what is left of the drive.
  ~SegdfNodelet() override;
  SegdfNodelet(const SegdfNodelet&) = delete;
  SegdfNodelet& operator=(const SegdfNodelet&) = delete;

 private:
  /// @throws what wrong parameters throw, after one FATAL line: the nodelet then does not load
  void onInit() override;
  void start();
  void startTf(const NodeParameters& node);
  std::unique_ptr<SensorMount> makeMount(const NodeParameters& node) const;
  Intake::Handlers intakeHandlers();
  void advertiseServices();
  void offerDisplayOptions();

  // In the services' threads.
  bool onFlush(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onReset(ResetRequest& request, ResetResponse& response);
  bool onSaveMap(SaveMapRequest& request, SaveMapResponse& response);
  std::string inWorker(std::function<std::string()> work);
  std::string saveMap(const std::string& destination, double resolution);

  void keepCallbackQueue();

  /// The manager frees it when it unloads the nodelet, which a callback at hand may outlive: the
  /// nodelet then ends in that callback's thread, and takes its callbacks out of it.
  boost::shared_ptr<ros::CallbackQueueInterface> callback_queue_;
  Ledger ledger_;

  // Goes from the end: nothing comes in while the worker stops. It is there as long as the outputs,
  // which ask it for the map when somebody wants to see it, but stops before them.
  std::unique_ptr<tf2_ros::Buffer> tf_buffer_;
  std::unique_ptr<tf2_ros::TransformListener> tf_listener_;
  std::unique_ptr<Worker> worker_;
  std::unique_ptr<OutputTopics> outputs_;
  std::unique_ptr<FilterStage> stage_;
  std::unique_ptr<Intake> intake_;
  std::unique_ptr<Diagnostics> diagnostics_;
  std::unique_ptr<dynamic_reconfigure::Server<DisplayConfig>> display_server_;
  ServiceThread filtering_;  ///< for services that wait for the worker
  ServiceThread saving_;
  ros::ServiceServer flush_service_;
  ros::ServiceServer reset_service_;
  ros::ServiceServer save_service_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <std_srvs/Trigger.h>

#include <nodelet/nodelet.h>
#include <ros/service_server.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>

#include "segdf/nodelets/live_filter.hpp"
#include "segdf/nodelets/output_topics.hpp"
#include "segdf/nodelets/tally.hpp"
#include "segdf/nodelets/worker.hpp"
#include "segdf/ros/parameters.hpp"
#include "segdf/ros/synchroniser.hpp"

namespace segdf {

/// The filter live. In: `cloud` (sensor_msgs/PointCloud2) and `odometry` (nav_msgs/Odometry) with
/// identical stamps. Out, in the odometry's frame: see OutputTopics. `~flush` (std_srvs/Trigger)
/// decides and publishes the frames that are still in the window, then the map.
///
/// ROS threads only pair messages and queue the pairs; one worker filters them in order, so that
/// the labels are those of the offline runner. What does not fit in the queue is counted and told.
class SegdfNodelet : public nodelet::Nodelet {
 private:
  /// @throws what wrong parameters throw, after one FATAL line: the nodelet then does not load
  void onInit() override;
  void start();
  void subscribe();

  // In ROS threads.
  void enqueue(const sensor_msgs::PointCloud2ConstPtr& cloud,
               const nav_msgs::OdometryConstPtr& odometry);
  void watch();
  void watchForSilence(const Synchroniser::Counts& counts);
  bool onFlush(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  // In the worker.
  void handle(const sensor_msgs::PointCloud2& cloud, const nav_msgs::Odometry& odometry);
  void take(Scan scan, const std_msgs::Header& header);
  void finishSession();
  void publish(const std::vector<FrameResult>& frames);
  void publishMap();
  void check(const FrameResult& frame);
  void tell(const std::string& kind, const std::string& what);

  NodeParameters parameters_;
  std::string cloud_topic_;
  std::string odometry_topic_;

  // The worker's own.
  std::unique_ptr<LiveFilter> filter_;
  std_msgs::Header header_;  ///< of the odometry of the latest scan
  std::size_t frames_ = 0;
  Tally troubles_;

  // The ROS threads' own.
  std::unique_ptr<Synchroniser> pairs_;
  std::size_t overflows_ = 0;  ///< pairs dropped because the queue was full
  Synchroniser::Counts seen_;  ///< at the last watch
  std::size_t overflows_seen_ = 0;
  bool silence_told_ = false;

  // Goes from the end: no message comes in while the worker stops, and it stops before what it
  // uses.
  std::unique_ptr<OutputTopics> outputs_;
  std::unique_ptr<Worker> worker_;
  ros::Subscriber cloud_subscriber_;
  ros::Subscriber odometry_subscriber_;
  ros::WallTimer watch_timer_;
  ros::ServiceServer flush_service_;
};

}  // namespace segdf

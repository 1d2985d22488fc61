// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <std_msgs/Header.h>

#include <segdf/DisplayConfig.h>

#include "segdf/core/frame_result.hpp"
#include "segdf/mapping/map_point.hpp"
#include "segdf/nodelets/ledger.hpp"

namespace segdf {

/// What the nodelet publishes in its private namespace: static_cloud, dynamic_cloud,
/// labelled_cloud, instances, markers, frame_report, and the latched static_map. Nothing is made
/// for a topic to which nobody listens.
class OutputTopics {
 public:
  /// All but the map. @param queue_size messages that may wait for a slow subscriber
  OutputTopics(ros::NodeHandle& node, int queue_size);

  /// And the map, before anything is published.
  /// @param on_viewer called, in a ROS thread, when somebody subscribes to it: at once by those who
  /// waited for it
  void offerMap(ros::NodeHandle& node, const std::function<void()>& on_viewer);

  /// How things are shown from now on. From any thread.
  void show(const DisplayConfig& display);

  /// @param frame_id of the map frame
  /// @param counts of everything until now
  void publish(const FrameResult& frame, const std::string& frame_id, const Counts& counts);

  bool mapHasViewers() const { return static_map_.getNumSubscribers() > 0; }
  /// Somebody looks at the map, and this frame is one of every map_every. @param frames until now
  bool isMapDue(std::size_t frames) const;
  void publishMap(const std::vector<MapPoint>& points, const std_msgs::Header& header);

 private:
  DisplayConfig display() const;

  mutable std::mutex display_mutex_;
  DisplayConfig display_ = DisplayConfig::__getDefault__();
  ros::Publisher static_cloud_;
  ros::Publisher dynamic_cloud_;
  ros::Publisher labelled_cloud_;
  ros::Publisher instances_;
  ros::Publisher markers_;
  ros::Publisher frame_report_;
  ros::Publisher static_map_;
};

}  // namespace segdf

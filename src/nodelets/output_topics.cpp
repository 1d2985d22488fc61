// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/output_topics.hpp"

#include <utility>

#include <boost/make_shared.hpp>

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "segdf/mapping/static_map.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/instance_messages.hpp"
#include "segdf/ros/markers.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointCloud2;

/// As a shared pointer, so that nodelets in the same manager get it without a copy.
template <class Message>
void publishShared(const ros::Publisher& publisher, Message message) {
  publisher.publish(boost::make_shared<const Message>(std::move(message)));
}

void publishCloud(const ros::Publisher& publisher,
                  const FrameResult& frame,
                  const std::string& frame_id,
                  CloudKind kind) {
  if (publisher.getNumSubscribers() == 0) return;
  publishShared(publisher, toCloud(frame, frame_id, kind));
}

}  // namespace

OutputTopics::OutputTopics(ros::NodeHandle& node, int queue_size) {
  const auto size = static_cast<std::uint32_t>(queue_size);
  static_cloud_ = node.advertise<PointCloud2>("static_cloud", size);
  dynamic_cloud_ = node.advertise<PointCloud2>("dynamic_cloud", size);
  labelled_cloud_ = node.advertise<PointCloud2>("labelled_cloud", size);
  instances_ = node.advertise<LabelledInstanceArray>("instances", size);
  frame_report_ = node.advertise<FrameReport>("frame_report", size);
  markers_ = node.advertise<visualization_msgs::MarkerArray>("markers", size);
}

void OutputTopics::offerMap(ros::NodeHandle& node, const std::function<void()>& on_viewer) {
  const auto connected = [on_viewer](const ros::SingleSubscriberPublisher&) { on_viewer(); };
  static_map_ = node.advertise<PointCloud2>(
      "static_map", 1, connected, ros::SubscriberStatusCallback(), ros::VoidConstPtr(), true);
}

void OutputTopics::show(const DisplayConfig& display) {
  const std::lock_guard<std::mutex> lock(display_mutex_);
  display_ = display;
}

DisplayConfig OutputTopics::display() const {
  const std::lock_guard<std::mutex> lock(display_mutex_);
  return display_;
}

bool OutputTopics::isMapDue(std::size_t frames) const {
  return frames % static_cast<std::size_t>(display().map_every) == 0 && mapHasViewers();
}

void OutputTopics::publish(const FrameResult& frame,
                           const std::string& frame_id,
                           const Counts& counts) {
  publishCloud(static_cloud_, frame, frame_id, CloudKind::kStatic);
  publishCloud(dynamic_cloud_, frame, frame_id, CloudKind::kDynamic);
  publishCloud(labelled_cloud_, frame, frame_id, CloudKind::kLabelled);
  if (markers_.getNumSubscribers() > 0) {
    publishShared(markers_, toMarkers(frame, frame_id, display()));
  }
  if (instances_.getNumSubscribers() > 0) publishShared(instances_, toInstances(frame, frame_id));
  if (frame_report_.getNumSubscribers() == 0) return;
  FrameReport report = toReport(frame, frame_id);
  fill(report, counts);
  publishShared(frame_report_, std::move(report));
}

void OutputTopics::publishMap(const std::vector<MapPoint>& points, const std_msgs::Header& header) {
  const double voxel = display().map_voxel;
  publishShared(static_map_, toCloud(voxel > 0.0 ? thinned(points, voxel) : points, header));
}

}  // namespace segdf

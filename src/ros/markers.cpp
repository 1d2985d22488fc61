// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/markers.hpp"

#include <algorithm>
#include <vector>

#include <Eigen/Geometry>
#include <tf2_eigen/tf2_eigen.h>

#include "segdf/ros/conversions.hpp"

namespace segdf {
namespace {

using visualization_msgs::Marker;

constexpr double kLeastSide = 0.05;    // metres; rviz complains about boxes without extent
constexpr double kArrowShaft = 0.15;   // metres
constexpr double kArrowHead = 0.4;     // metres
constexpr double kLeastSpeed = 0.2;    // m/s; below it an arrow would only jitter
constexpr double kTextDistance = 0.5;  // metres above the box

std_msgs::ColorRGBA verdictColour(bool dynamic, float alpha) {
  std_msgs::ColorRGBA colour;
  colour.r = dynamic ? 0.9F : 0.1F;
  colour.g = dynamic ? 0.1F : 0.8F;
  colour.b = 0.1F;
  colour.a = alpha;
  return colour;
}

Marker deleteAll(const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.action = Marker::DELETEALL;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker markerOf(const InstanceObservation& instance, const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.id = static_cast<int>(instance.id);
  marker.action = Marker::ADD;
  const Eigen::Quaterniond heading(Eigen::AngleAxisd(instance.yaw, Eigen::Vector3d::UnitZ()));
  marker.pose.position = tf2::toMsg(instance.center);
  marker.pose.orientation = tf2::toMsg(heading);
  return marker;
}

Marker box(const InstanceObservation& instance, const std_msgs::Header& header, double opacity) {
  Marker marker = markerOf(instance, header);
  marker.ns = "box/" + toString(instance.object_class);
  marker.type = Marker::CUBE;
  marker.scale.x = std::max(instance.size.x(), kLeastSide);
  marker.scale.y = std::max(instance.size.y(), kLeastSide);
  marker.scale.z = std::max(instance.size.z(), kLeastSide);
  marker.color = verdictColour(instance.dynamic, static_cast<float>(opacity));
  return marker;
}

Marker text(const InstanceObservation& instance, const std_msgs::Header& header, double height) {
  Marker marker = markerOf(instance, header);
  marker.ns = "text/" + toString(instance.object_class);
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.pose.position.z += 0.5 * (instance.size.z() + height) + kTextDistance;
  marker.scale.z = height;
  marker.color = verdictColour(instance.dynamic, 1.0F);
  marker.text = std::to_string(instance.id) + " " + toString(instance.object_class);
  return marker;
}

/// From the box's centre to where it will be in a second.
Marker arrow(const InstanceObservation& instance, const std_msgs::Header& header) {
  Marker marker = markerOf(instance, header);
  marker.ns = "motion/" + toString(instance.object_class);
  marker.type = Marker::ARROW;
  marker.pose.position = geometry_msgs::Point();  // the points are in the header's frame
  marker.pose.orientation = tf2::toMsg(Eigen::Quaterniond::Identity());
  marker.points = {tf2::toMsg(instance.center),
                   tf2::toMsg(Eigen::Vector3d(instance.center + instance.velocity))};
  marker.scale.x = kArrowShaft;
  marker.scale.y = kArrowHead;
  marker.color = verdictColour(instance.dynamic, 1.0F);
  return marker;
}

bool isMover(const InstanceObservation& instance) {
  return instance.dynamic && instance.velocity.norm() >= kLeastSpeed;
}

}  // namespace

visualization_msgs::MarkerArray toMarkers(const FrameResult& frame,
                                          const std::string& frame_id,
                                          const DisplayConfig& display) {
  const std_msgs::Header header = toHeader(frame.scan, frame_id);
  visualization_msgs::MarkerArray array;
  std::vector<Marker>& markers = array.markers;
  markers.push_back(deleteAll(header));
  for (const InstanceObservation& instance : frame.instances) {
    if (display.box_opacity > 0.0) markers.push_back(box(instance, header, display.box_opacity));
    if (display.text_size > 0.0) markers.push_back(text(instance, header, display.text_size));
    if (isMover(instance)) markers.push_back(arrow(instance, header));
  }
  return array;
}

}  // namespace segdf

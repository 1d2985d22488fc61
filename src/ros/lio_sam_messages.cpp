// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/lio_sam_messages.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <tf2_eigen/tf2_eigen.h>

#include <sensor_msgs/point_cloud2_iterator.h>

#include "segdf/ros/cloud_fields.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointField;

std_msgs::Header headerOf(const Scan& scan, const std::string& frame) {
  std_msgs::Header header;
  header.stamp.fromNSec(static_cast<std::uint64_t>(scan.stamp_ns));
  header.frame_id = frame;
  return header;
}

sensor_msgs::PointCloud2 emptyCloud(const Scan& scan, const std::string& frame) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = headerOf(scan, frame);
  cloud.height = 1;
  cloud.is_bigendian = 0;
  return cloud;
}

void addPositionFields(sensor_msgs::PointCloud2& cloud) {
  for (const char* name : {"x", "y", "z", "intensity"}) addField(cloud, name, PointField::FLOAT32);
}

/// Calls `write(iterator, item)` for each item, where the field of its point lies. The iterator
/// takes the address of the first point, which an empty cloud does not have.
template <class Number, class Item, class Write>
void fillField(sensor_msgs::PointCloud2& cloud,
               const std::string& name,
               const std::vector<Item>& items,
               const Write& write) {
  if (items.empty()) return;
  sensor_msgs::PointCloud2Iterator<Number> out(cloud, name);
  for (const Item& item : items) {
    write(out, item);
    ++out;
  }
}

void fillPositions(sensor_msgs::PointCloud2& cloud, const Scan& scan, const Pose& frame_T_sensor) {
  fillField<float>(cloud, "x", scan.points, [&](auto& out, const Point& point) {
    const Eigen::Vector3f position =
        (frame_T_sensor * point.position().cast<double>()).cast<float>();
    for (int axis = 0; axis < 3; ++axis) out[axis] = position[axis];
    out[3] = point.intensity;
  });
}

bool hasRings(const Scan& scan) {
  return std::all_of(scan.points.begin(), scan.points.end(),
                     [](const Point& point) { return point.ring >= 0; });
}

void fillRings(sensor_msgs::PointCloud2& cloud, const Scan& scan) {
  fillField<std::uint16_t>(cloud, "ring", scan.points, [](auto& out, const Point& point) {
    *out = static_cast<std::uint16_t>(point.ring);
  });
}

void fillTimes(sensor_msgs::PointCloud2& cloud, const Scan& scan) {
  fillField<float>(cloud, "time", scan.points,
                   [](auto& out, const Point& point) { *out = point.time; });
}

void setSize(sensor_msgs::PointCloud2& cloud, std::size_t points) {
  sensor_msgs::PointCloud2Modifier(cloud).resize(points);
}

}  // namespace

sensor_msgs::PointCloud2 toRegisteredCloud(const Scan& scan) {
  sensor_msgs::PointCloud2 cloud = emptyCloud(scan, topics::kOdometryFrame);
  addPositionFields(cloud);
  setSize(cloud, scan.points.size());
  fillPositions(cloud, scan, scan.pose);
  return cloud;
}

sensor_msgs::PointCloud2 toSensorCloud(const Scan& scan) {
  sensor_msgs::PointCloud2 cloud = emptyCloud(scan, topics::kSensorFrame);
  const bool rings = hasRings(scan);
  addPositionFields(cloud);
  if (rings) addField(cloud, "ring", PointField::UINT16);
  addField(cloud, "time", PointField::FLOAT32);
  setSize(cloud, scan.points.size());
  fillPositions(cloud, scan, Pose::Identity());
  if (rings) fillRings(cloud, scan);
  fillTimes(cloud, scan);
  return cloud;
}

nav_msgs::Odometry toOdometry(const Scan& scan) {
  nav_msgs::Odometry odometry;
  odometry.header = headerOf(scan, topics::kOdometryFrame);
  odometry.child_frame_id = topics::kOdometryChildFrame;
  odometry.pose.pose = tf2::toMsg(scan.pose);
  return odometry;
}

geometry_msgs::TransformStamped toTransform(const Scan& scan) {
  geometry_msgs::TransformStamped transform = tf2::eigenToTransform(scan.pose);
  transform.header = headerOf(scan, topics::kOdometryFrame);
  transform.child_frame_id = topics::kSensorFrame;
  return transform;
}

sensor_msgs::PointCloud2 toTruthCloud(const Scan& scan, const std::vector<std::uint32_t>& truth) {
  sensor_msgs::PointCloud2 cloud = emptyCloud(scan, topics::kSensorFrame);
  addField(cloud, "label", PointField::UINT32);
  setSize(cloud, truth.size());
  fillField<std::uint32_t>(cloud, "label", truth,
                           [](auto& out, std::uint32_t label) { *out = label; });
  return cloud;
}

}  // namespace segdf

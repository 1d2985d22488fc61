// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/lio_sam_messages.hpp"

#include <algorithm>
#include <string>

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

void fillPositions(sensor_msgs::PointCloud2& cloud, const Scan& scan, const Pose& frame_T_sensor) {
  sensor_msgs::PointCloud2Iterator<float> out(cloud, "x");
  for (const Point& point : scan.points) {
    const Eigen::Vector3f position =
        (frame_T_sensor * point.position().cast<double>()).cast<float>();
    for (int axis = 0; axis < 3; ++axis) out[axis] = position[axis];
    out[3] = point.intensity;
    ++out;
  }
}

bool hasRings(const Scan& scan) {
  return std::all_of(scan.points.begin(), scan.points.end(),
                     [](const Point& point) { return point.ring >= 0; });
}

void fillRings(sensor_msgs::PointCloud2& cloud, const Scan& scan) {
  sensor_msgs::PointCloud2Iterator<std::uint16_t> out(cloud, "ring");
  for (const Point& point : scan.points) {
    *out = static_cast<std::uint16_t>(point.ring);
    ++out;
  }
}

void fillTimes(sensor_msgs::PointCloud2& cloud, const Scan& scan) {
  sensor_msgs::PointCloud2Iterator<float> out(cloud, "time");
  for (const Point& point : scan.points) {
    *out = point.time;
    ++out;
  }
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
  sensor_msgs::PointCloud2Iterator<std::uint32_t> out(cloud, "label");
  for (const std::uint32_t label : truth) {
    *out = label;
    ++out;
  }
  return cloud;
}

}  // namespace segdf

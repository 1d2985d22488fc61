// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/tf_poses.hpp"

#include <utility>

#include <boost/make_shared.hpp>

namespace segdf {
namespace {

nav_msgs::Odometry toOdometry(const geometry_msgs::TransformStamped& transform) {
  nav_msgs::Odometry odometry;
  odometry.header = transform.header;
  odometry.child_frame_id = transform.child_frame_id;
  odometry.pose.pose.position.x = transform.transform.translation.x;
  odometry.pose.pose.position.y = transform.transform.translation.y;
  odometry.pose.pose.position.z = transform.transform.translation.z;
  odometry.pose.pose.orientation = transform.transform.rotation;
  return odometry;
}

}  // namespace

TfPoses::TfPoses(const tf2_ros::Buffer& buffer,
                 std::string map_frame,
                 std::string sensor_frame,
                 std::size_t queue_size,
                 PairCallback on_pair)
    : CloudQueue(queue_size, std::move(on_pair)),
      buffer_(buffer),
      map_frame_(std::move(map_frame)),
      sensor_frame_(std::move(sensor_frame)) {}

nav_msgs::OdometryConstPtr TfPoses::findPose(const sensor_msgs::PointCloud2& cloud) {
  const ros::Time& stamp = cloud.header.stamp;
  if (!buffer_.canTransform(map_frame_, sensorOf(cloud), stamp)) return nullptr;
  return boost::make_shared<nav_msgs::Odometry>(
      toOdometry(buffer_.lookupTransform(map_frame_, sensorOf(cloud), stamp)));
}

const std::string& TfPoses::sensorOf(const sensor_msgs::PointCloud2& cloud) const {
  return sensor_frame_.empty() ? cloud.header.frame_id : sensor_frame_;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/sensor_mount.hpp"

#include <utility>

#include <boost/make_shared.hpp>
#include <tf2_eigen/tf2_eigen.h>

#include <ros/init.h>
#include <ros/time.h>
#include <tf2_sensor_msgs/tf2_sensor_msgs.h>

#include "segdf/io/scan_source.hpp"

namespace segdf {
namespace {

constexpr double kPatience = 5.0;  // seconds of wall time
constexpr double kPoll = 0.02;

}  // namespace

SensorMount::SensorMount(const tf2_ros::Buffer& buffer,
                         std::string base_frame,
                         std::string sensor_frame)
    : buffer_(buffer), base_frame_(std::move(base_frame)), sensor_frame_(std::move(sensor_frame)) {}

SensorMount::Seen SensorMount::apply(const sensor_msgs::PointCloud2ConstPtr& cloud,
                                     const nav_msgs::Odometry& odometry) {
  const std::string& cloud_frame = cloud->header.frame_id;
  const bool registered = cloud_frame == odometry.header.frame_id;
  const std::string base = base_frame_.empty() ? odometry.child_frame_id : base_frame_;
  const std::string of_cloud = registered ? base : cloud_frame;
  const std::string sensor = sensor_frame_.empty() ? of_cloud : sensor_frame_;
  Seen seen{cloud, odometry};
  if (sensor != base) {
    Eigen::Isometry3d map_T_base;
    tf2::fromMsg(odometry.pose.pose, map_T_base);
    seen.odometry.pose.pose = tf2::toMsg(map_T_base * tf2::transformToEigen(lookUp(base, sensor)));
  }
  if (!registered && cloud_frame != sensor) {
    auto moved = boost::make_shared<sensor_msgs::PointCloud2>();
    tf2::doTransform(*cloud, *moved, lookUp(sensor, cloud_frame));
    moved->header.stamp = cloud->header.stamp;
    seen.cloud = moved;
  }
  return seen;
}

geometry_msgs::TransformStamped SensorMount::lookUp(const std::string& target,
                                                    const std::string& source) {
  if (waitFor(target, source)) return buffer_.lookupTransform(target, source, ros::Time(0));
  throw IoError("tf does not say where '" + source + "' is in '" + target +
                "': publish that static transform, or set base_frame and sensor_frame to frames "
                "that tf connects");
}

/// In wall time, since the bag's clock may stand still.
bool SensorMount::waitFor(const std::string& target, const std::string& source) {
  const auto known = [&] { return buffer_.canTransform(target, source, ros::Time(0)); };
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!known() && !waited_ && ros::ok() && ros::WallTime::now() < end) {
    ros::WallDuration(kPoll).sleep();
  }
  waited_ = true;
  return known();
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/tf_poses.hpp"

#include <utility>

#include <boost/make_shared.hpp>

namespace segdf {
namespace {

using CloudPtr = sensor_msgs::PointCloud2ConstPtr;

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
                 Synchroniser::PairCallback on_pair)
    : buffer_(buffer),
      map_frame_(std::move(map_frame)),
      sensor_frame_(std::move(sensor_frame)),
      queue_size_(queue_size),
      on_pair_(std::move(on_pair)) {}

void TfPoses::addCloud(const CloudPtr& cloud) {
  ++counts_.clouds;
  clouds_.push_back(cloud);
  pairUp();
  if (clouds_.size() <= queue_size_) return;
  clouds_.pop_front();
  ++counts_.unmatched;
}

void TfPoses::pairUp() {
  while (pairOne()) {
  }
}

/// tf comes in order: a cloud before one that has its pose will not get one any more.
bool TfPoses::pairOne() {
  for (std::size_t k = 0; k < clouds_.size(); ++k) {
    const CloudPtr cloud = clouds_[k];
    const ros::Time& stamp = cloud->header.stamp;
    if (!buffer_.canTransform(map_frame_, sensorOf(*cloud), stamp)) continue;
    const auto pose = boost::make_shared<nav_msgs::Odometry>(
        toOdometry(buffer_.lookupTransform(map_frame_, sensorOf(*cloud), stamp)));
    clouds_.erase(clouds_.begin(), clouds_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    counts_.unmatched += k;
    ++counts_.pairs;
    on_pair_(cloud, pose);
    return true;
  }
  return false;
}

const std::string& TfPoses::sensorOf(const sensor_msgs::PointCloud2& cloud) const {
  return sensor_frame_.empty() ? cloud.header.frame_id : sensor_frame_;
}

}  // namespace segdf

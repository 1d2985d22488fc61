// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/synchroniser.hpp"

#include <cstdint>
#include <utility>

namespace segdf {
namespace {

using CloudPtr = sensor_msgs::PointCloud2ConstPtr;
using OdometryPtr = nav_msgs::OdometryConstPtr;

}  // namespace

Synchroniser::Synchroniser(std::size_t queue_size, PairCallback on_pair)
    : on_pair_(std::move(on_pair)), pairs_(Policy(static_cast<std::uint32_t>(queue_size))) {
  pairs_.registerCallback(&Synchroniser::onPair, this);
  pairs_.getPolicy()->registerDropCallback(&Synchroniser::onDrop, this);
}

void Synchroniser::addCloud(const CloudPtr& cloud) {
  ++counts_.clouds;
  pairs_.add<0>(ros::MessageEvent<const sensor_msgs::PointCloud2>(cloud, cloud->header.stamp));
}

void Synchroniser::addOdometry(const OdometryPtr& odometry) {
  ++counts_.poses;
  pairs_.add<1>(ros::MessageEvent<const nav_msgs::Odometry>(odometry, odometry->header.stamp));
}

void Synchroniser::onPair(const CloudPtr& cloud, const OdometryPtr& odometry) {
  ++counts_.pairs;
  on_pair_(cloud, odometry);
}

void Synchroniser::onDrop(const CloudPtr& cloud, const OdometryPtr& /*odometry*/) {
  if (cloud) ++counts_.unmatched;
}

}  // namespace segdf

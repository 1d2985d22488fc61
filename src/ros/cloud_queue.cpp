// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/cloud_queue.hpp"

#include <utility>

namespace segdf {

CloudQueue::CloudQueue(std::size_t queue_size, PairCallback on_pair)
    : queue_size_(queue_size), on_pair_(std::move(on_pair)) {}

void CloudQueue::addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  ++counts_.clouds;
  clouds_.push_back(cloud);
  pairUp();
  if (clouds_.size() <= queue_size_) return;
  clouds_.pop_front();
  ++counts_.unmatched;
}

void CloudQueue::pairUp() {
  while (pairOne()) {
  }
}

/// Poses come in order: a cloud before one that has its pose will not get one any more.
bool CloudQueue::pairOne() {
  for (std::size_t k = 0; k < clouds_.size(); ++k) {
    const sensor_msgs::PointCloud2ConstPtr cloud = clouds_[k];
    const nav_msgs::OdometryConstPtr pose = findPose(*cloud);
    if (!pose) continue;
    clouds_.erase(clouds_.begin(), clouds_.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    counts_.unmatched += k;
    ++counts_.pairs;
    on_pair_(cloud, pose);
    return true;
  }
  return false;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/synchroniser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <boost/make_shared.hpp>
#include <tf2_eigen/tf2_eigen.h>

namespace segdf {
namespace {

using OdometryPtr = nav_msgs::OdometryConstPtr;

constexpr std::size_t kPosesPerCloud = 10;  // they are small, and may come at a higher rate

double distance(const ros::Time& a, const ros::Time& b) { return std::abs((a - b).toSec()); }

/// As it is, where there is nothing to interpolate.
OdometryPtr poseAt(const ros::Time& stamp, const OdometryPtr& before, const OdometryPtr& after) {
  if (before == after) return before;
  return boost::make_shared<nav_msgs::Odometry>(interpolate(*before, *after, stamp));
}

}  // namespace

Synchroniser::Synchroniser(std::size_t queue_size, double slop, PairCallback on_pair)
    : CloudQueue(queue_size, std::move(on_pair)), slop_(slop) {}

void Synchroniser::addOdometry(const OdometryPtr& odometry) {
  countPose();
  poses_.push_back(odometry);
  if (poses_.size() > kPosesPerCloud * queueSize()) poses_.pop_front();
  pairUp();
}

std::size_t Synchroniser::posesAfter(const ros::Time& stamp) const {
  return static_cast<std::size_t>(
      std::count_if(poses_.begin(), poses_.end(),
                    [&](const OdometryPtr& pose) { return pose->header.stamp > stamp; }));
}

/// What came before the pose finds no cloud any more; interpolation may need it once again.
OdometryPtr Synchroniser::findPose(const sensor_msgs::PointCloud2& cloud) {
  const ros::Time& stamp = cloud.header.stamp;
  const std::optional<Neighbours> found = find(stamp);
  if (!found) return nullptr;
  OdometryPtr pose = poseAt(stamp, poses_[found->before], poses_[found->after]);
  const auto first = static_cast<std::ptrdiff_t>(std::min(found->before, found->after));
  poses_.erase(poses_.begin(), poses_.begin() + first + (slop_ > 0.0 ? 0 : 1));
  return pose;
}

std::optional<Synchroniser::Neighbours> Synchroniser::find(const ros::Time& stamp) const {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    if (poses_[i]->header.stamp == stamp) return Neighbours{i, i};
  }
  return slop_ > 0.0 ? findAround(stamp) : std::nullopt;
}

std::optional<Synchroniser::Neighbours> Synchroniser::findAround(const ros::Time& stamp) const {
  std::optional<std::size_t> before;
  std::optional<std::size_t> after;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const ros::Time& time = poses_[i]->header.stamp;
    if (time < stamp && (!before || time > poses_[*before]->header.stamp)) before = i;
    if (time > stamp && (!after || time < poses_[*after]->header.stamp)) after = i;
  }
  if (!after) return std::nullopt;  // it may still come
  if (!before) before = after;
  const double nearest = std::min(distance(stamp, poses_[*before]->header.stamp),
                                  distance(stamp, poses_[*after]->header.stamp));
  return nearest <= slop_ ? std::optional(Neighbours{*before, *after}) : std::nullopt;
}

nav_msgs::Odometry interpolate(const nav_msgs::Odometry& before,
                               const nav_msgs::Odometry& after,
                               const ros::Time& stamp) {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  Eigen::Quaterniond from_turn;
  Eigen::Quaterniond to_turn;
  tf2::fromMsg(before.pose.pose.position, from);
  tf2::fromMsg(after.pose.pose.position, to);
  tf2::fromMsg(before.pose.pose.orientation, from_turn);
  tf2::fromMsg(after.pose.pose.orientation, to_turn);
  const double share =
      (stamp - before.header.stamp).toSec() / (after.header.stamp - before.header.stamp).toSec();
  nav_msgs::Odometry between = before;
  between.header.stamp = stamp;
  between.pose.pose.position = tf2::toMsg(Eigen::Vector3d(from + share * (to - from)));
  between.pose.pose.orientation = tf2::toMsg(from_turn.slerp(share, to_turn));
  return between;
}

}  // namespace segdf

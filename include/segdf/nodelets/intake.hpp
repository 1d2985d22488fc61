// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <tf2_ros/buffer.h>

#include "segdf/nodelets/ledger.hpp"
#include "segdf/nodelets/player_brake.hpp"
#include "segdf/nodelets/tf_poses.hpp"
#include "segdf/ros/parameters.hpp"
#include "segdf/ros/synchroniser.hpp"

namespace segdf {

/// What comes in: `cloud`, and `odometry` or tf. Hands on pairs, keeps the ledger, and tells the
/// user what is missing. All of it in the ROS thread of one callback queue.
class Intake {
 public:
  struct Handlers {
    /// Takes a pair; false if there is no room for it, and it is dropped.
    std::function<bool(const sensor_msgs::PointCloud2ConstPtr&, const nav_msgs::OdometryConstPtr&)>
        on_pair;
    /// The last publisher of the clouds has gone; called again until it returns true.
    std::function<bool()> on_end;
  };

  /// @param name of the logger
  /// @param ledger outlives the intake
  /// @param buffer of tf, outlives the intake; needed for use_tf only
  Intake(ros::NodeHandle node,
         const NodeParameters& parameters,
         std::string name,
         Ledger& ledger,
         Handlers handlers,
         const tf2_ros::Buffer* buffer);

 private:
  void addCloud(const sensor_msgs::PointCloud2ConstPtr& cloud);
  void addOdometry(const nav_msgs::OdometryConstPtr& odometry);
  void hand(const sensor_msgs::PointCloud2ConstPtr& cloud,
            const nav_msgs::OdometryConstPtr& odometry);
  void countGap(const std_msgs::Header& header);
  CloudQueue& queue();
  void book();
  void poll();

  void watch();
  void watchForSilence();
  void watchForLosses();
  void watchForTheEnd();
  void warnOfNoPair(const Counts& counts) const;
  void warnOfTheTail() const;
  std::string expectation(const Counts& counts) const;

  NodeParameters parameters_;
  std::string name_;
  Ledger& ledger_;
  Handlers handlers_;
  PlayerBrake brake_;
  std::unique_ptr<Synchroniser> synchroniser_;  ///< one of the two
  std::unique_ptr<TfPoses> tf_poses_;
  std::optional<std_msgs::Header> last_cloud_;
  std::optional<std_msgs::Header> last_pose_;

  Counts seen_;  ///< at the last watch
  int silent_ticks_ = 0;
  int orphan_ticks_ = 0;  ///< without publisher
  bool ended_ = true;     ///< nothing has come since the last end

  ros::Subscriber cloud_subscriber_;
  ros::Subscriber odometry_subscriber_;
  ros::WallTimer watch_timer_;
  ros::WallTimer poll_timer_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include <ros/node_handle.h>
#include <ros/service_client.h>

namespace segdf {

/// Holds `rosbag play` while more scans wait than the filter can take, so that a bag can be played
/// at any speed without a drop. For one thread.
class PlayerBrake {
 public:
  /// @param player its node; empty: there is none, and nothing is ever held
  /// @param capacity scans that may wait: from half of it on the player is held, down to a quarter
  PlayerBrake(ros::NodeHandle& node, const std::string& player, std::size_t capacity);
  /// Lets the player go.
  ~PlayerBrake();
  PlayerBrake(const PlayerBrake&) = delete;
  PlayerBrake& operator=(const PlayerBrake&) = delete;

  /// @param waiting scans that wait now
  void look(std::size_t waiting);

 private:
  void set(bool held);

  ros::ServiceClient pause_;
  std::size_t capacity_;
  bool held_ = false;
};

}  // namespace segdf

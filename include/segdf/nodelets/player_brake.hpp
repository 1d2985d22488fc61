// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <future>
#include <string>

#include <ros/node_handle.h>
#include <ros/service_client.h>

namespace segdf {

/// Holds `rosbag play` while more scans wait than the filter can take, so that a bag can be played
/// at any speed without a drop. For one thread, which never waits for the player.
class PlayerBrake {
 public:
  /// @param player its node; empty: there is none, and nothing is ever held
  /// @param capacity scans that may wait: from half of it on the player is held, down to a quarter
  PlayerBrake(const ros::NodeHandle& node, const std::string& player, std::size_t capacity);
  /// Lets the player go, if it answers within a second.
  ~PlayerBrake();
  PlayerBrake(const PlayerBrake&) = delete;
  PlayerBrake& operator=(const PlayerBrake&) = delete;

  /// @param waiting scans that wait now
  void look(std::size_t waiting);

 private:
  void ask(bool hold);
  bool hasAnswered();
  void awaitAnswer();

  ros::NodeHandle node_;
  std::string service_;  ///< empty: no player
  std::size_t capacity_;
  ros::ServiceClient client_;
  std::future<bool> answer_;  ///< whether the player is held now
  bool held_ = false;         ///< by the last answer
};

}  // namespace segdf

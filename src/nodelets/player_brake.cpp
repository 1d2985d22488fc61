// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/player_brake.hpp"

#include <std_srvs/SetBool.h>

namespace segdf {

PlayerBrake::PlayerBrake(ros::NodeHandle& node, const std::string& player, std::size_t capacity)
    : capacity_(capacity) {
  if (player.empty()) return;
  pause_ = node.serviceClient<std_srvs::SetBool>(player + "/pause_playback");
}

PlayerBrake::~PlayerBrake() {
  if (held_) set(false);
}

void PlayerBrake::look(std::size_t waiting) {
  if (!pause_.isValid()) return;
  if (!held_ && waiting >= (capacity_ + 1) / 2) set(true);
  if (held_ && waiting <= capacity_ / 4) set(false);
}

/// A player that does not answer has come to its end.
void PlayerBrake::set(bool held) {
  std_srvs::SetBool pause;
  pause.request.data = static_cast<std::uint8_t>(held);
  held_ = pause_.call(pause) && held;
}

}  // namespace segdf

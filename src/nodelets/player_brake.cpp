// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/player_brake.hpp"

#include <chrono>
#include <cstdint>

#include <std_srvs/SetBool.h>

namespace segdf {
namespace {

constexpr std::chrono::seconds kPatience{1};

/// @return whether the player is held now: one that does not answer has come to its end
bool call(ros::ServiceClient client, bool hold) {
  std_srvs::SetBool pause;
  pause.request.data = static_cast<std::uint8_t>(hold);
  return client.call(pause) && hold;
}

}  // namespace

PlayerBrake::PlayerBrake(const ros::NodeHandle& node,
                         const std::string& player,
                         std::size_t capacity)
    : node_(node),
      service_(player.empty() ? "" : player + "/pause_playback"),
      capacity_(capacity) {}

PlayerBrake::~PlayerBrake() {
  awaitAnswer();
  if (!held_) return;
  ask(false);
  awaitAnswer();
}

void PlayerBrake::look(std::size_t waiting) {
  if (service_.empty() || !hasAnswered()) return;
  if (!held_ && waiting >= (capacity_ + 1) / 2) {
    ask(true);
  } else if (held_ && waiting <= capacity_ / 4) {
    ask(false);
  }
}

/// In a thread of its own: `rosbag play --keep-alive` at a high rate never answers when it is done.
void PlayerBrake::ask(bool hold) {
  // Persistent, as only such a client's call can be broken off.
  client_ = node_.serviceClient<std_srvs::SetBool>(service_, true);
  answer_ = std::async(std::launch::async, call, client_, hold);
}

bool PlayerBrake::hasAnswered() {
  if (!answer_.valid()) return true;
  if (answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  held_ = answer_.get();
  return true;
}

void PlayerBrake::awaitAnswer() {
  if (!answer_.valid()) return;
  while (answer_.wait_for(kPatience) != std::future_status::ready) client_.shutdown();
  held_ = answer_.get();
}

}  // namespace segdf

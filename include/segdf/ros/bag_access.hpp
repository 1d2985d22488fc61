// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include <boost/shared_ptr.hpp>

#include <rosbag/bag.h>
#include <rosbag/message_instance.h>
#include <std_msgs/Header.h>

#include "segdf/io/scan_source.hpp"
#include "segdf/ros/topic_choice.hpp"

/// What everything that reads bags shares: opening, and rosbag's exceptions as lines for the user.
namespace segdf {

/// @throws IoError that asks for 'rosbag reindex' where that may help
[[noreturn]] void refuseBag(const std::filesystem::path& file, const std::exception& reason);

/// @throws IoError if there is no such file, it is no ROS 1 bag, or it has no usable index
std::unique_ptr<rosbag::Bag> openBag(const std::filesystem::path& file);

/// All topics of the bag that have messages or connections.
TopicTypes topicTypes(const rosbag::Bag& bag);

/// Header stamp in nanoseconds.
std::int64_t stampOf(const std_msgs::Header& header);

/// @throws IoError if the message was recorded with another definition of its type
template <class Message>
boost::shared_ptr<Message> readMessage(const rosbag::MessageInstance& instance) {
  boost::shared_ptr<Message> message = instance.instantiate<Message>();
  if (message) return message;
  throw IoError("topic '" + instance.getTopic() + "' has " + instance.getDataType() +
                " messages of another definition than this ROS: convert the bag with rosbag fix");
}

}  // namespace segdf

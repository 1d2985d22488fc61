// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

namespace segdf {

/// Answers services, one after the other, in a thread of its own. One that waits, for the filter or
/// for the disk, must not do so in a thread of the nodelet manager: the manager gives each thread
/// its callbacks beforehand, and those behind the service would wait with it.
class ServiceThread {
 public:
  ServiceThread() { spinner_.start(); }

  /// @return like `node`; what is advertised with it is answered here, and must be shut down before
  /// this goes
  ros::NodeHandle handle(ros::NodeHandle node) {
    node.setCallbackQueue(&queue_);
    return node;
  }

 private:
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_{1, &queue_};
};

}  // namespace segdf

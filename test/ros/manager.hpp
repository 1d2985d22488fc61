// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/ros.h>

#include "ros/node_client.hpp"

/// The node /segdf in and out of the launch file's nodelet manager.
namespace segdf::test {

inline void loadNode() {
  ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", ros::Duration(30)));
  nodelet::NodeletLoad call;
  call.request.name = "/segdf";
  call.request.type = "segdf/SegdfNodelet";
  ASSERT_TRUE(spinUntil([&call] {
    return ros::service::call("/manager/load_nodelet", call) && call.response.success;
  }));
}

inline void unloadNode() {
  nodelet::NodeletUnload call;
  call.request.name = "/segdf";
  ASSERT_TRUE(ros::service::call("/manager/unload_nodelet", call));
  EXPECT_TRUE(call.response.success);
}

}  // namespace segdf::test

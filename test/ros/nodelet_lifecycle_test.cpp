// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest (nodelet_lifecycle.test): the nodelet loaded and unloaded again and again in
// one manager, and the manager killed while it saves a map. The manager respawns.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <nav_msgs/Odometry.h>
#include <nodelet/NodeletLoad.h>
#include <nodelet/NodeletUnload.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <segdf/SaveMap.h>

#include "segdf/io/pcd_stream.hpp"
#include "segdf/ros/lio_sam_messages.hpp"

#include "ros/node_client.hpp"
#include "ros/sample_scan.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

constexpr std::size_t kPoints = 30000;
constexpr int kScans = 4;

/// Process id of a node, 0 if it does not answer.
pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return 0;
  std::string host;
  std::uint32_t port = 0;
  ros::network::splitURI(static_cast<std::string>(uri), host, port);
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue caller;
  caller[0] = ros::this_node::getName();
  if (!client.execute("getPid", caller, response)) return 0;
  return static_cast<int>(response[2]);
}

/// Memory that a process holds, MB.
double residentMegabytes(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/statm");
  double all = 0.0;
  double resident = 0.0;
  file >> all >> resident;
  return resident * 4096.0 / 1e6;
}

class NodeletLifecycle : public ::testing::Test {
 protected:
  void load() {
    ASSERT_TRUE(ros::service::waitForService("/manager/load_nodelet", ros::Duration(30)));
    nodelet::NodeletLoad call;
    call.request.name = "/segdf";
    call.request.type = "segdf/SegdfNodelet";
    ASSERT_TRUE(test::spinUntil([&call] {
      return ros::service::call("/manager/load_nodelet", call) && call.response.success;
    }));
  }

  void unload() {
    nodelet::NodeletUnload call;
    call.request.name = "/segdf";
    ASSERT_TRUE(ros::service::call("/manager/unload_nodelet", call));
    EXPECT_TRUE(call.response.success);
  }

  /// Some scans, and their decision. @return the node's line
  std::string drive() {
    EXPECT_TRUE(test::spinUntil(
        [this] { return cloud_.getNumSubscribers() > 0 && odometry_.getNumSubscribers() > 0; }));
    for (int k = 0; k < kScans; ++k) {
      const Scan scan = test::sampleScan(kPoints, (1000 + k) * std::int64_t{100'000'000});
      odometry_.publish(toOdometry(scan));
      cloud_.publish(toSensorCloud(scan));
    }
    std::string line;
    test::spinUntil([&line] {
      line = test::NodeClient::flush();
      return line.rfind(std::to_string(kScans) + " frames", 0) == 0;
    });
    return line;
  }

  ros::NodeHandle node_;
  ros::Publisher cloud_ = node_.advertise<sensor_msgs::PointCloud2>("/cloud", 10);
  ros::Publisher odometry_ = node_.advertise<nav_msgs::Odometry>("/odometry", 10);
};

TEST_F(NodeletLifecycle, LoadedAndUnloadedOverAndOverItKeepsNothing) {
  // A scan with its segments takes some 10 MB in the window: a nodelet that stayed behind would
  // show from the first round on. The first rounds are for what malloc keeps for good.
  constexpr int kWarmUp = 3;
  constexpr int kRounds = 8;
  constexpr double kMegabytes = 15.0;
  double before = 0.0;
  for (int round = 0; round < kWarmUp + kRounds; ++round) {
    load();
    const std::string line = drive();
    ASSERT_EQ(line.rfind(std::to_string(kScans) + " frames", 0), 0U) << line;
    unload();
    if (round == kWarmUp - 1) before = residentMegabytes(processOf("/manager"));
  }
  ASSERT_GT(before, 0.0);
  const double after = residentMegabytes(processOf("/manager"));
  RecordProperty("before_mb", std::to_string(before));
  RecordProperty("after_mb", std::to_string(after));
  EXPECT_LT(after - before, kMegabytes) << before << " MB before, " << after << " MB after";
}

TEST_F(NodeletLifecycle, KilledWhileItSavesItLeavesAWholeMapOrNone) {
  const test::TempFolder folder;
  // Most of the scans' random points have a voxel of their own: 0.7 MB, written within
  // milliseconds.
  for (const int milliseconds : {0, 2, 5, 15}) {
    load();
    drive();
    const std::string map = folder / ("map_" + std::to_string(milliseconds) + ".pcd");
    std::thread saving([&map] {
      SaveMap call;
      call.request.destination = map;
      ros::service::call("/segdf/save_map", call);  // no answer comes from a killed node
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ASSERT_EQ(kill(processOf("/manager"), SIGKILL), 0);
    saving.join();
    if (!std::filesystem::exists(map)) continue;
    std::size_t points = 0;
    EXPECT_NO_THROW(forEachPoint(map, [&points](const MapPoint&) { ++points; }));
    EXPECT_GT(points, kPoints / 2) << milliseconds << " ms";
  }
}

}  // namespace
}  // namespace segdf

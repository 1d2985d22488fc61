// SPDX-License-Identifier: BSD-3-Clause
// A nodelet manager that loads the nodelet, gives it a drive, and unloads it, over and over.
// check_leaks.sh runs it under valgrind, which tells of memory that was lost; threads that stay
// behind the test itself counts.
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <geometry_msgs/TransformStamped.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <visualization_msgs/MarkerArray.h>

#include <segdf/LabelledInstanceArray.h>
#include <segdf/SaveMap.h>

#include "segdf/ros/topics.hpp"

#include "ros/node_client.hpp"
#include "ros/scan_publisher.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

constexpr int kRounds = 3;
constexpr int kScans = 3;
constexpr std::size_t kPoints = 2000;  // valgrind takes thirty times as long
constexpr const char* kBase = "base";

std::size_t threads() {
  const std::filesystem::directory_iterator tasks("/proc/self/task");
  return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
}

void save(const std::filesystem::path& map) {
  SaveMap call;
  call.request.destination = map;
  ASSERT_TRUE(ros::service::call("/segdf/save_map", call));
  EXPECT_TRUE(call.response.success) << call.response.message;
}

/// Nothing is made for a topic to which nobody listens.
class Listener {
 public:
  Listener() {
    for (const char* topic : {"static_cloud", "dynamic_cloud", "labelled_cloud", "static_map"}) {
      listen<sensor_msgs::PointCloud2>(topic);
    }
    listen<visualization_msgs::MarkerArray>("markers");
    listen<LabelledInstanceArray>("instances");
    listen<FrameReport>("frame_report");
  }

 private:
  template <class Message>
  void listen(const std::string& topic) {
    const boost::function<void(const boost::shared_ptr<const Message>&)> ignore = [](auto) {};
    subscribers_.push_back(node_.subscribe<Message>("/segdf/" + topic, test::kQueueSize, ignore));
  }

  ros::NodeHandle node_;
  std::vector<ros::Subscriber> subscribers_;
};

/// All that the nodelet can have: files, and the way to the sensor from tf.
void setParameters(const std::filesystem::path& results) {
  ros::param::set("/segdf/sensor", "hdl64");
  ros::param::set("/segdf/threads", 1);
  ros::param::set("/segdf/output_dir", results.string());
  ros::param::set("/segdf/base_frame", kBase);
}

geometry_msgs::TransformStamped mounting() {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = kBase;
  transform.child_frame_id = topics::kSensorFrame;
  transform.transform.rotation.w = 1.0;
  return transform;
}

TEST(NodeletLeaks, NoThreadStaysBehind) {
  const test::TempFolder folder;
  setParameters(folder / "results");
  tf2_ros::StaticTransformBroadcaster broadcaster;
  broadcaster.sendTransform(mounting());
  nodelet::Loader manager(ros::NodeHandle("/manager"));
  const Listener listener;
  test::ScanPublisher scans(kPoints);
  // roscpp starts its thread for wall timers with the first of them, and keeps it.
  const ros::WallTimer timer =
      ros::NodeHandle().createWallTimer(ros::WallDuration(1.0), [](const ros::WallTimerEvent&) {});
  const std::size_t before = threads();
  for (int round = 0; round < kRounds; ++round) {
    ASSERT_TRUE(manager.load("/segdf", "segdf/SegdfNodelet", {}, {}));
    scans.publish(kScans);
    ASSERT_TRUE(test::NodeClient::flushUntil(kScans));
    save(folder / ("map_" + std::to_string(round) + ".pcd"));
    scans.publish(kScans);  // to be unloaded with scans in queue and window
    ASSERT_TRUE(manager.unload("/segdf"));
    // A thread ends a little after that for which it was needed.
    ASSERT_TRUE(test::spinUntil([before] { return threads() <= before; }))
        << before << " threads before, " << threads() << " after round " << round;
  }
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest: the nodelet's services and latched topics, after a bag was played at a speed
// that it cannot keep up with.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <segdf/LabelledInstanceArray.h>
#include <segdf/Reset.h>
#include <segdf/SaveMap.h>

#include "segdf/io/pcd_stream.hpp"
#include "segdf/ros/topics.hpp"

#include "ros/node_client.hpp"
#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using test::contains;

SaveMapResponse save(const std::string& destination, float resolution = 0.0F) {
  SaveMap call;
  call.request.destination = destination;
  call.request.resolution = resolution;
  EXPECT_TRUE(ros::service::call("/segdf/save_map", call));
  EXPECT_FALSE(call.response.message.empty());
  return call.response;
}

ResetResponse reset(bool keep_map) {
  Reset call;
  call.request.keep_map = static_cast<std::uint8_t>(keep_map);
  EXPECT_TRUE(ros::service::call("/segdf/reset", call));
  return call.response;
}

std::size_t pointsIn(const std::filesystem::path& pcd) {
  std::size_t points = 0;
  forEachPoint(pcd, [&points](const MapPoint&) { ++points; });
  return points;
}

class NodeletServices : public ::testing::Test {
 protected:
  ros::NodeHandle node_;
};

// In the order in which they stand: this one lets the player begin, and leaves the map to the
// others; the last one clears it.
TEST_F(NodeletServices, WhatIsDroppedIsCounted) {
  test::NodeClient client;
  std::size_t played = 0;
  std::size_t instances = 0;
  std::size_t arrays = 0;
  std::size_t markers = 0;
  const ros::Subscriber on_instances = node_.subscribe<LabelledInstanceArray>(
      "/segdf/instances", test::kQueueSize, [&](const LabelledInstanceArrayConstPtr& array) {
        ++arrays;
        instances += array->instances.size();
      });
  const ros::Subscriber on_markers = node_.subscribe<visualization_msgs::MarkerArray>(
      "/segdf/markers", test::kQueueSize,
      [&](const visualization_msgs::MarkerArrayConstPtr& array) {
        markers += array->markers.size();
      });
  ASSERT_TRUE(test::spinUntil([&] {
    return client.isConnected() && on_instances.getNumPublishers() > 0 &&
           on_markers.getNumPublishers() > 0;
  }));
  const ros::Subscriber truth = node_.subscribe<sensor_msgs::PointCloud2>(
      topics::kTruthLabels, test::kQueueSize,
      [&played](const sensor_msgs::PointCloud2ConstPtr&) { ++played; });
  const std::size_t scans = test::labelFiles(ros::param::param<std::string>("~labels", "")).size();
  ASSERT_TRUE(test::spinUntil([&] { return played >= scans; }));
  ASSERT_TRUE(client.waitUntilReceived(scans));
  const std::string line = test::NodeClient::flush();
  ASSERT_TRUE(test::spinUntil([&] {
    return !client.reports.empty() && client.frames.size() >= client.reports.back().scans_processed;
  }));
  test::spinUntil([&] { return arrays >= client.frames.size() && markers > 2 * instances; });
  const FrameReport& last = client.reports.back();
  test::expectAccounted(last);
  EXPECT_EQ(last.clouds_received, scans);
  EXPECT_GT(last.scans_dropped, 0U) << "at 1000 times the speed";
  EXPECT_EQ(last.scans_processed + last.scans_dropped, scans);
  EXPECT_EQ(client.frames.size(), last.scans_processed);
  EXPECT_TRUE(contains(line, std::to_string(last.scans_dropped) + " dropped"));
  EXPECT_EQ(arrays, client.frames.size());
  EXPECT_GT(instances, arrays) << "a street has more than one object";
  EXPECT_GT(markers, 2 * instances) << "a box and a text each, and what deletes the old ones";
  for (const FrameReport& report : client.reports) {
    EXPECT_GT(report.points_ground + report.points_static, 0U);
  }
}

TEST_F(NodeletServices, LateViewerGetsTheMap) {
  std::size_t points = 0;
  const ros::Subscriber map = node_.subscribe<sensor_msgs::PointCloud2>(
      "/segdf/static_map", 1, [&points](const sensor_msgs::PointCloud2ConstPtr& cloud) {
        EXPECT_EQ(cloud->header.frame_id, topics::kOdometryFrame);
        points = cloud->width;
      });
  EXPECT_TRUE(test::spinUntil([&points] { return points > 0; }));
}

TEST_F(NodeletServices, DiagnosticsTellInputAndFilter) {
  std::map<std::string, std::string> values;
  std::vector<std::string> names;
  const ros::Subscriber diagnostics = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
      "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArrayConstPtr& array) {
        for (const auto& status : array->status) {
          names.push_back(status.name);
          for (const auto& pair : status.values) values[pair.key] = pair.value;
        }
      });
  ASSERT_TRUE(test::spinUntil([&] { return names.size() >= 2; }));
  EXPECT_EQ(names[0], "segdf: input");
  EXPECT_EQ(names[1], "segdf: filter");
  EXPECT_EQ(std::stoul(values["clouds received"]),
            std::stoul(values["scans filtered"]) + std::stoul(values["scans dropped"]));
}

TEST_F(NodeletServices, SaveMapWritesMapAndInstances) {
  const test::TempFolder folder;
  const SaveMapResponse fine = save(folder / "town.pcd");
  ASSERT_TRUE(fine.success) << fine.message;
  const std::size_t points = pointsIn(folder / "town.pcd");
  EXPECT_GT(points, 1000U);
  EXPECT_TRUE(contains(fine.message, std::to_string(points) + " points"));
  EXPECT_TRUE(contains(test::readText(folder / "town_instances.csv"), "id,parent,class"));
  ASSERT_TRUE(save(folder / "coarse.pcd", 1.0F).success);
  EXPECT_LT(pointsIn(folder / "coarse.pcd"), points / 2) << "1 m against 0.2 m";
  const SaveMapResponse ply = save(folder / "city.ply", 0.5F);
  EXPECT_TRUE(ply.success) << ply.message;
  EXPECT_TRUE(contains(test::readText(folder / "city.ply"), "element vertex"));
}

TEST_F(NodeletServices, SaveMapRefusesWhatItMustNotTouch) {
  const test::TempFolder folder;
  ASSERT_TRUE(save(folder / "town.pcd").success);
  const auto written = std::filesystem::last_write_time(folder / "town.pcd");
  EXPECT_TRUE(contains(save(folder / "town.pcd").message, "left alone"));
  EXPECT_EQ(std::filesystem::last_write_time(folder / "town.pcd"), written);
  EXPECT_FALSE(save("map.pcd").success);
  EXPECT_FALSE(save(folder / "no/such/folder/map.pcd").success);
  EXPECT_FALSE(save(folder / "map.pcd", -1.0F).success);
}

TEST_F(NodeletServices, ResetKeepsOrClearsTheMap) {
  const test::TempFolder folder;
  EXPECT_TRUE(reset(true).success);
  EXPECT_TRUE(save(folder / "kept.pcd").success);
  EXPECT_TRUE(reset(false).success);
  const SaveMapResponse empty = save(folder / "cleared.pcd");
  EXPECT_FALSE(empty.success);
  EXPECT_TRUE(contains(empty.message, "still empty"));
  EXPECT_FALSE(std::filesystem::exists(folder / "cleared.pcd"));
}

}  // namespace
}  // namespace segdf

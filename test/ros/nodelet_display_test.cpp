// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest: what dynamic_reconfigure offers, and what it changes while the node runs.
#include <algorithm>
#include <string>
#include <vector>

#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <segdf/SaveMap.h>

#include "segdf/io/pcd_stream.hpp"
#include "segdf/ros/topics.hpp"

#include "ros/node_client.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using dynamic_reconfigure::Config;
using visualization_msgs::Marker;

/// @return what is in force afterwards
Config set(const std::string& name, double value) {
  dynamic_reconfigure::Reconfigure call;
  dynamic_reconfigure::DoubleParameter parameter;
  parameter.name = name;
  parameter.value = value;
  call.request.config.doubles.push_back(parameter);
  EXPECT_TRUE(ros::service::waitForService("/segdf/set_parameters", ros::Duration(30)));
  EXPECT_TRUE(ros::service::call("/segdf/set_parameters", call)) << name;
  return call.response.config;
}

double valueOf(const Config& config, const std::string& name) {
  for (const auto& parameter : config.doubles) {
    if (parameter.name == name) return parameter.value;
  }
  return -1.0;
}

/// The player waits until somebody listens.
void ignore(const sensor_msgs::PointCloud2ConstPtr& /*cloud*/) {}

class NodeletDisplay : public ::testing::Test {
 protected:
  ros::NodeHandle node_;
};

// In the order in which they stand: the second lets the player begin.
TEST_F(NodeletDisplay, OffersDisplayOptionsAndNothingThatLabelsDependOn) {
  std::vector<std::string> names;
  const ros::Subscriber descriptions = node_.subscribe<dynamic_reconfigure::ConfigDescription>(
      "/segdf/parameter_descriptions", 1,
      [&names](const dynamic_reconfigure::ConfigDescriptionConstPtr& description) {
        for (const auto& parameter : description->groups.at(0).parameters) {
          names.push_back(parameter.name);
        }
      });
  ASSERT_TRUE(test::spinUntil([&names] { return !names.empty(); }));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names,
            (std::vector<std::string>{"box_opacity", "map_every", "map_voxel", "text_size"}));
  EXPECT_EQ(valueOf(set("ground/th_seed", 0.1), "ground/th_seed"), -1.0) << "must be unknown";
  EXPECT_FALSE(ros::param::has("/segdf/ground"));
}

TEST_F(NodeletDisplay, TextsAndBoxesChange) {
  constexpr double kTextSize = 2.5;  // none of the defaults
  constexpr double kOpacity = 0.75;
  EXPECT_EQ(valueOf(set("text_size", kTextSize), "text_size"), kTextSize);
  EXPECT_EQ(valueOf(set("box_opacity", kOpacity), "box_opacity"), kOpacity);
  std::size_t texts = 0;
  std::size_t boxes = 0;
  const ros::Subscriber markers = node_.subscribe<visualization_msgs::MarkerArray>(
      "/segdf/markers", test::kQueueSize,
      [&](const visualization_msgs::MarkerArrayConstPtr& array) {
        for (const Marker& marker : array->markers) {
          if (marker.type == Marker::TEXT_VIEW_FACING) {
            ++texts;
            EXPECT_EQ(marker.scale.z, kTextSize);
          } else if (marker.type == Marker::CUBE && marker.action == Marker::ADD) {
            ++boxes;
            EXPECT_EQ(marker.color.a, static_cast<float>(kOpacity));
          }
        }
      });
  const ros::Subscriber truth =
      node_.subscribe<sensor_msgs::PointCloud2>(topics::kTruthLabels, test::kQueueSize, ignore);
  EXPECT_TRUE(test::spinUntil([&] { return texts > 0 && boxes > 0; }));
}

TEST_F(NodeletDisplay, MapVoxelThinsWhatIsShownAndNotWhatIsSaved) {
  const std::string frames =
      std::to_string(test::labelFiles(ros::param::param<std::string>("~labels", "")).size());
  ASSERT_TRUE(test::spinUntil(
      [&frames] { return test::NodeClient::flush().rfind(frames + " frames", 0) == 0; }));
  std::size_t points = 0;
  const ros::Subscriber map = node_.subscribe<sensor_msgs::PointCloud2>(
      "/segdf/static_map", 1,
      [&points](const sensor_msgs::PointCloud2ConstPtr& cloud) { points = cloud->width; });
  ASSERT_TRUE(test::spinUntil([&points] { return points > 0; }));
  const std::size_t all = points;
  set("map_voxel", 1.0);
  EXPECT_TRUE(test::spinUntil([&] { return points < all / 2; })) << "1 m against 0.2 m";
  const test::TempFolder folder;
  SaveMap save;
  save.request.destination = folder / "town.pcd";
  ASSERT_TRUE(ros::service::call("/segdf/save_map", save));
  std::size_t saved = 0;
  forEachPoint(folder / "town.pcd", [&saved](const MapPoint&) { ++saved; });
  EXPECT_EQ(saved, all);
  set("map_voxel", 0.0);
  EXPECT_TRUE(test::spinUntil([&] { return points == all; }));
}

}  // namespace
}  // namespace segdf

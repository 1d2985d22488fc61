// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <sensor_msgs/point_cloud2_iterator.h>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/ros/colours.hpp"
#include "segdf/ros/conversions.hpp"
#include "segdf/ros/instance_messages.hpp"
#include "segdf/ros/markers.hpp"

#include "ros/sample_scan.hpp"

namespace segdf {
namespace {

using visualization_msgs::Marker;

constexpr std::uint32_t kWholeId = 70001;  // does not fit in the upper half of a label

/// Five points, one in each state.
FrameResult sampleFrame() {
  FrameResult frame;
  frame.scan = test::sampleScan(5, 2'000'000'000);
  frame.labels.resize(5);
  frame.labels[1].state = PointState::kGround;
  frame.labels[2] = {kWholeId, PointState::kStatic, ObjectClass::kHighMobility};
  frame.labels[3] = {7, PointState::kDynamic, ObjectClass::kHighMobility};
  frame.labels[4].state = PointState::kNoise;
  return frame;
}

std::vector<std::uint32_t> column(const sensor_msgs::PointCloud2& cloud, const std::string& field) {
  std::vector<std::uint32_t> values;
  sensor_msgs::PointCloud2ConstIterator<std::uint32_t> it(cloud, field);
  for (; it != it.end(); ++it) values.push_back(*it);
  return values;
}

TEST(ToCloud, LabelledHoldsEveryPointInInputOrder) {
  const FrameResult frame = sampleFrame();
  const sensor_msgs::PointCloud2 cloud = toCloud(frame, "odom", CloudKind::kLabelled);
  EXPECT_EQ(cloud.header.frame_id, "odom");
  EXPECT_EQ(cloud.header.stamp, ros::Time(2, 0));
  EXPECT_EQ(column(cloud, "label"), (std::vector<std::uint32_t>{0, 40, 10, 251, 9}));
  EXPECT_EQ(column(cloud, "instance"), (std::vector<std::uint32_t>{0, 0, kWholeId, 7, 0}));
  sensor_msgs::PointCloud2ConstIterator<float> it(cloud, "x");
  for (std::size_t i = 0; i < 5; ++i, ++it) {
    const Eigen::Vector3d expected =
        frame.scan.pose * frame.scan.points[i].position().cast<double>();
    EXPECT_NEAR((Eigen::Vector3f(it[0], it[1], it[2]).cast<double>() - expected).norm(), 0.0, 1e-4);
    EXPECT_EQ(it[3], frame.scan.points[i].intensity);
  }
}

TEST(ToCloud, StaticAndDynamicPartShareTheJudgedPoints) {
  const FrameResult frame = sampleFrame();
  EXPECT_EQ(column(toCloud(frame, "odom", CloudKind::kStatic), "label"),
            (std::vector<std::uint32_t>{40, 10, 9}));
  EXPECT_EQ(column(toCloud(frame, "odom", CloudKind::kDynamic), "label"),
            (std::vector<std::uint32_t>{251}));
}

TEST(ToCloud, ScanThatWasNotMappedIsPublishedUnjudged) {
  FrameResult frame = sampleFrame();
  frame.status = FrameStatus::kTimeBackwards;
  frame.labels.assign(5, {});
  EXPECT_EQ(column(toCloud(frame, "odom", CloudKind::kLabelled), "label"),
            std::vector<std::uint32_t>(5, 0));
}

TEST(Colours, RedIsOnlyForWhatWasRemoved) {
  const Colour removed = colourOf(semantic_kitti::kDynamic, 3);
  EXPECT_GT(removed.r, 200);
  EXPECT_LT(removed.g, 60);
  for (std::uint32_t instance = 1; instance < 500; ++instance) {
    const Colour colour = colourOf(semantic_kitti::kCar, instance);
    // Between yellow and violet one of the others is as strong as red.
    EXPECT_GE(std::max(colour.g, colour.b), colour.r) << instance;
  }
}

TEST(Colours, NeighbouringInstancesDiffer) {
  for (std::uint32_t instance = 1; instance < 500; ++instance) {
    EXPECT_NE(pack(colourOf(semantic_kitti::kCar, instance)),
              pack(colourOf(semantic_kitti::kCar, instance + 1)));
  }
}

TEST(Markers, OnlyWhatMovesAndWasFollowedGetsAnArrow) {
  FrameResult frame = sampleFrame();
  InstanceObservation parked;
  parked.center = {1.0, 2.0, 0.5};
  parked.velocity = {3.0, 0.0, 0.0};  // the next car's box taken for it
  InstanceObservation mover = parked;
  mover.dynamic = true;
  InstanceObservation lost = mover;
  lost.velocity.setZero();
  frame.instances = {parked, mover, lost};
  std::vector<Marker> arrows;
  for (const Marker& marker : toMarkers(frame, "odom", DisplayConfig::__getDefault__()).markers) {
    if (marker.type == Marker::ARROW && marker.action == Marker::ADD) arrows.push_back(marker);
  }
  ASSERT_EQ(arrows.size(), 1U);
  ASSERT_EQ(arrows[0].points.size(), 2U);
  EXPECT_EQ(arrows[0].points[0].x, 1.0);
  EXPECT_EQ(arrows[0].points[1].x, 4.0);
  EXPECT_EQ(arrows[0].pose.orientation.w, 1.0);
}

TEST(InstanceMessages, HoldWhatTheFrameSays) {
  FrameResult frame = sampleFrame();
  InstanceObservation car;
  car.id = kWholeId;
  car.parent = 3;
  car.object_class = ObjectClass::kHighMobility;
  car.dynamic = true;
  car.points = 42;
  car.dynamic_votes = 5;
  car.needed_votes = 3;
  car.reason = Reason::kTrack;
  car.center = {1.0, 2.0, 3.0};
  car.size = {4.0, 2.0, 1.5};
  car.velocity = {0.0, 7.0, 0.0};
  frame.instances = {car};
  const LabelledInstanceArray array = toInstances(frame, "odom");
  EXPECT_EQ(array.header.stamp, ros::Time(2, 0));
  EXPECT_EQ(array.header.frame_id, "odom");
  ASSERT_EQ(array.instances.size(), 1U);
  const LabelledInstance& message = array.instances[0];
  EXPECT_EQ(message.id, kWholeId);
  EXPECT_EQ(message.parent, 3U);
  EXPECT_EQ(message.object_class, LabelledInstance::CLASS_HIGH_MOBILITY);
  EXPECT_EQ(message.class_name, "high_mobility");
  EXPECT_TRUE(message.dynamic);
  EXPECT_EQ(message.points, 42U);
  EXPECT_EQ(message.pose.position.z, 3.0);
  EXPECT_EQ(message.size.x, 4.0);
  EXPECT_EQ(message.velocity.y, 7.0);
  EXPECT_EQ(message.dynamic_votes, 5U);
  EXPECT_EQ(message.needed_votes, 3U);
  EXPECT_EQ(message.reason, "track");
}

TEST(InstanceMessages, ReportCountsEveryPointOnce) {
  FrameResult frame = sampleFrame();
  frame.index = 17;
  frame.pose_misfit = 0.05;
  frame.times.ground = 0.25;
  frame.times.dynamics = 0.5;
  const FrameReport report = toReport(frame, "odom");
  EXPECT_EQ(report.index, 17U);
  EXPECT_EQ(report.status, FrameReport::MAPPED);
  EXPECT_EQ(report.points_unjudged, 1U);
  EXPECT_EQ(report.points_ground, 1U);
  EXPECT_EQ(report.points_static, 1U);
  EXPECT_EQ(report.points_dynamic, 1U);
  EXPECT_EQ(report.points_noise, 1U);
  EXPECT_FLOAT_EQ(report.pose_misfit, 0.05F);
  EXPECT_FLOAT_EQ(report.processing_time, 0.75F);
}

TEST(Markers, BoxAndTextForEachInstanceAfterDeleteAll) {
  FrameResult frame = sampleFrame();
  InstanceObservation car;
  car.id = 12;
  car.object_class = ObjectClass::kHighMobility;
  car.dynamic = true;
  car.center = {1.0, 2.0, 3.0};
  car.size = {4.0, 2.0, 0.0};
  car.yaw = 0.5;
  frame.instances = {car};
  const auto markers = toMarkers(frame, "odom", DisplayConfig::__getDefault__()).markers;
  ASSERT_EQ(markers.size(), 3U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(markers[1].type, Marker::CUBE);
  EXPECT_EQ(markers[1].ns, "box/high_mobility");
  EXPECT_GT(markers[1].scale.z, 0.0) << "rviz refuses boxes without height";
  EXPECT_GT(markers[1].color.r, markers[1].color.g) << "dynamic is red";
  EXPECT_NEAR(markers[1].pose.orientation.z, std::sin(0.25), 1e-12);
  EXPECT_EQ(markers[2].text, "12 high_mobility");
  for (const Marker& marker : markers) EXPECT_EQ(marker.header.frame_id, "odom");
}

TEST(Markers, DisplayOptionsGiveSizeAndOpacityOrNone) {
  FrameResult frame = sampleFrame();
  frame.instances.resize(1);
  DisplayConfig display = DisplayConfig::__getDefault__();
  display.text_size = 2.5;
  display.box_opacity = 0.5;
  const auto both = toMarkers(frame, "odom", display).markers;
  ASSERT_EQ(both.size(), 3U);
  EXPECT_EQ(both[1].color.a, 0.5F);
  EXPECT_EQ(both[2].scale.z, 2.5);
  display.text_size = 0.0;
  const auto box = toMarkers(frame, "odom", display).markers;
  ASSERT_EQ(box.size(), 2U);
  EXPECT_EQ(box[1].type, Marker::CUBE);
  display.box_opacity = 0.0;
  EXPECT_EQ(toMarkers(frame, "odom", display).markers.size(), 1U);
}

}  // namespace
}  // namespace segdf

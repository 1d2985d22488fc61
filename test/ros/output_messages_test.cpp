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
  const auto markers = toMarkers(frame, "odom").markers;
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

}  // namespace
}  // namespace segdf

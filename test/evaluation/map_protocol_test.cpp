// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/evaluation/map_protocol.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "segdf/evaluation/map_overlap.hpp"

namespace segdf {
namespace {

Scan scanOf(const std::vector<Eigen::Vector3f>& points) {
  Scan scan;
  for (const Eigen::Vector3f& p : points) {
    scan.points.push_back({p.x(), p.y(), p.z(), 0.0F, 0.0F, -1});
  }
  return scan;
}

TEST(MapProtocol, HandComputedExample) {
  // The map holds the points at x = 10, 11 and 12.
  MapProtocol protocol({{10.0F, 0.0F, 0.0F}, {11.0F, 0.0F, 0.0F}, {12.0F, 0.0F, 0.0F}});
  protocol.add(scanOf({{10.0F, 0.0F, 0.0F},    // static, there
                       {11.0F, 0.04F, 0.0F},   // static, 4 cm beside
                       {12.0F, 0.0F, 0.06F},   // static, 6 cm above: lost
                       {20.0F, 0.0F, 0.0F},    // static, not there
                       {12.0F, 0.03F, 0.03F},  // moving, 4.2 cm from a kept point: not removed
                       {12.0F, 0.04F, 0.04F},  // moving, 5.7 cm: removed
                       {30.0F, 0.0F, 0.0F},    // moving, removed
                       {10.0F, 0.0F, 0.0F},    // unlabelled
                       {0.0F, 50.1F, 0.0F}}),  // out of range
               {50, 40, 70, 50, 252, 252, 254, 0, 50});
  const PointScores& scores = protocol.scores();
  EXPECT_EQ(scores.staticKept().part, 2U);
  EXPECT_EQ(scores.staticKept().whole, 4U);
  EXPECT_EQ(scores.movingRemoved().part, 2U);
  EXPECT_EQ(scores.movingRemoved().whole, 3U);
  EXPECT_DOUBLE_EQ(*scores.rightOfClass(252).percent(), 50.0);
}

TEST(MapProtocol, TheScanIsTakenIntoTheMapFrame) {
  MapProtocol protocol({{105.0F, 10.0F, 0.0F}});
  Scan scan = scanOf({{10.0F, 0.0F, 0.0F}});
  scan.pose.linear() << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;  // a quarter turn to the left
  scan.pose.translation() = Eigen::Vector3d(105.0, 0.0, 0.0);
  protocol.add(scan, {50});
  EXPECT_DOUBLE_EQ(*protocol.scores().staticKept().percent(), 100.0);
}

TEST(MapProtocol, ListsOfDifferentLengthAreRefused) {
  MapProtocol protocol({});
  EXPECT_THROW(protocol.add(scanOf({{1.0F, 0.0F, 0.0F}}), {}), std::invalid_argument);
}

TEST(MapOverlap, FindsTheHeightOfTheSensor) {
  std::vector<Eigen::Vector3f> truth;
  std::vector<Eigen::Vector3f> map;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) {
      truth.emplace_back(x, y, -1.7F);
      map.emplace_back(x, y, 0.0F);
    }
  }
  const MapOverlap overlap = measureOverlap(truth, map);
  EXPECT_DOUBLE_EQ(overlap.share, 0.0);
  EXPECT_DOUBLE_EQ(overlap.raised_share, 1.0);
  EXPECT_NEAR(overlap.raise, -1.7, 0.051) << "to half a step";
  const MapOverlap fits = measureOverlap(truth, truth);
  EXPECT_DOUBLE_EQ(fits.share, 1.0);
  EXPECT_DOUBLE_EQ(fits.raise, 0.0);
}

}  // namespace
}  // namespace segdf

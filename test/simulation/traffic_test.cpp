// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/traffic.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "segdf/simulation/ground.hpp"
#include "segdf/simulation/ground_rectangle.hpp"

namespace segdf {
namespace {

constexpr double kQuarter = 1.5707963267948966;

RoadUser car(std::vector<StreetPoint> corners, double speed = 8.0) {
  RoadUser user(Route(CentreLine(), corners, 5.0));
  user.speed = speed;
  return user;
}

TEST(CentreLine, NearestIsTheInverseOfPlace) {
  const CentreLine line({{30.0, kQuarter, 25.0}, {120.0, -0.7, 40.0}});
  for (double along = -20.0; along < 200.0; along += 7.3) {
    for (double across : {-11.0, -1.75, 0.0, 9.0}) {
      const Place place = line.place({along, across});
      const StreetPoint back = line.nearest(place.x, place.y);
      EXPECT_NEAR(back.along, along, 1e-6);
      EXPECT_NEAR(back.across, across, 1e-6);
    }
  }
  const Place turned = line.place({100.0, 0.0});
  EXPECT_NEAR(turned.yaw, kQuarter, 1e-9);
  EXPECT_NEAR(turned.x, 55.0, 1e-9) << "30 m and the radius";
  EXPECT_THROW(CentreLine({{30.0, kQuarter, 25.0}, {40.0, 0.5, 25.0}}), std::invalid_argument);
}

TEST(Terrain, GradesClimbAndKerbsStep) {
  Terrain ground;
  ground.undulation = 0.0;
  ground.grades = {{20.0, 70.0, 4.0}};
  ground.junctions = {100.0};
  EXPECT_NEAR(ground.heightAt(0.0, 0.0), 0.0, 1e-9);
  EXPECT_NEAR(ground.heightAt(45.0, 0.0), 1.0, 1e-9) << "25 m of 4 %";
  EXPECT_NEAR(ground.heightAt(90.0, 0.0), 2.0, 1e-9) << "50 m of 4 %";
  EXPECT_NEAR(ground.heightAt(90.0, 8.0), 2.12, 1e-9) << "on the kerb";
  EXPECT_NEAR(ground.heightAt(100.0, 8.0), 2.0, 1e-9) << "no kerb at a junction";
  EXPECT_EQ(ground.classAt({0.0, 3.0}), Terrain::kRoad);
  EXPECT_EQ(ground.classAt({0.0, -6.0}), Terrain::kParking);
  EXPECT_EQ(ground.classAt({0.0, -8.0}), Terrain::kSidewalk);
  EXPECT_EQ(ground.classAt({0.0, 12.0}), Terrain::kTerrain);
  EXPECT_EQ(ground.classAt({100.0, 12.0}), Terrain::kRoad);
}

TEST(GroundRectangle, OverlapIsThatOfTurnedRectangles) {
  const GroundRectangle a{{0.0, 0.0, 0.0}, 4.0, 2.0};
  EXPECT_TRUE(overlap(a, {{2.9, 0.0, 0.0}, 2.0, 2.0}));
  EXPECT_FALSE(overlap(a, {{3.1, 0.0, 0.0}, 2.0, 2.0}));
  // A square on its corner reaches 1.41 m.
  EXPECT_TRUE(overlap(a, {{3.3, 0.0, kQuarter / 2.0}, 2.0, 2.0}));
  EXPECT_FALSE(overlap(a, {{3.5, 0.0, kQuarter / 2.0}, 2.0, 2.0}));
}

TEST(Route, TurnsTakeTheirRadiusAndTheirSpeed) {
  const Route route(CentreLine(), {{0.0, 0.0}, {50.0, 0.0}, {50.0, 50.0}}, 5.0);
  EXPECT_LT(route.length(), 100.0) << "the corner is cut";
  EXPECT_GT(route.length(), 97.0);
  EXPECT_NEAR(route.at(20.0).x, 20.0, 1e-9);
  EXPECT_NEAR(route.at(80.0).yaw, kQuarter, 1e-6);
  // A curve of 2.5 m radius at its tightest is taken at 1.8 m/s^2: sqrt(1.8 * 2.5) = 2.1 m/s.
  EXPECT_GT(route.speedAt(20.0), 8.0);
  EXPECT_NEAR(route.speedAt(route.length() / 2.0), 2.3, 0.4);
  EXPECT_EQ(route.speedAt(route.length()), 0.0);
}

TEST(Traffic, AFollowerStaysBehind) {
  // The one ahead halts after 20 m; the other one comes up at twice its speed.
  RoadUser first = car({{15.0, 0.0}, {200.0, 0.0}}, 5.0);
  first.halts = {{20.0, 6.0}};
  const auto paths = driveTogether({car({{0.0, 0.0}, {200.0, 0.0}}, 10.0), first}, {}, 9.0, 20.0);
  bool stood = false;
  for (std::size_t k = 1; k < paths[0].size(); ++k) {
    const double gap = paths[1][k].x - paths[0][k].x - 4.4;
    ASSERT_GT(gap, 1.0) << "at " << paths[0][k].time;
    stood = stood || paths[0][k].way - paths[0][k - 1].way < 1e-4;
  }
  EXPECT_TRUE(stood);
  EXPECT_NEAR(paths[1].back().way, 20.0 + 5.0 * (20.0 - 4.0 - 6.0), 12.0) << "it goes on";
}

TEST(Traffic, RedMeansStopAndGreenGo) {
  RoadUser user = car({{0.0, 0.0}, {300.0, 0.0}});
  user.obeys_lights = true;
  RoadUser other = car({{0.0, 10.0}, {300.0, 10.0}});
  const auto paths = driveTogether({user, other}, {{60.0, {{0.0, 15.0}}}}, 9.0, 25.0);
  const double front = interpolate(paths[0], 14.9).x + 2.2;
  EXPECT_NEAR(front, 51.0, 0.5) << "at the line, 9 m before the crossing";
  EXPECT_GT(paths[0].back().x, 70.0) << "after 15 s it is green";
  EXPECT_NEAR(paths[1].back().x, 200.0, 0.1) << "not for this one";
}

TEST(Traffic, WhoNeverSetsOutHasOneWayPoint) {
  RoadUser late = car({{0.0, 0.0}, {50.0, 0.0}});
  late.start = 30.0;
  RoadUser blocked = car({{-6.0, 0.0}, {50.0, 0.0}});
  blocked.start = 1.0;
  const auto paths = driveTogether({late, blocked}, {}, 9.0, 10.0);
  EXPECT_EQ(paths[0].size(), 1U);
  EXPECT_EQ(paths[1].size(), 1U) << "1.6 m behind the other one, it waits";
}

}  // namespace
}  // namespace segdf

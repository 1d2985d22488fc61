// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/object_feet.hpp"

#include <gtest/gtest.h>

#include "segdf/segmentation/arc_tangent.hpp"
#include "segdf/segmentation/ground.hpp"
#include "segdf/segmentation/segmenter.hpp"

#include "support/box_world.hpp"

namespace segdf {
namespace {

/// Points of one kind that are labelled ground, and all of them.
struct Count {
  int ground = 0;
  int all = 0;
};

struct Counts {
  Count standing;  ///< points on boxes
  Count floor;     ///< points on the ground
};

Counts count(const Scan& scan, const std::vector<PointRole>& roles) {
  Counts counts;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const double z = (scan.pose * scan.points[i].position().cast<double>()).z();
    Count& kind = z > 1e-3 ? counts.standing : counts.floor;
    ++kind.all;
    kind.ground += roles[i] == PointRole::kGround ? 1 : 0;
  }
  return counts;
}

/// What comes after the feet is another test's (vehicle_feet_test.cpp).
Config withoutVehicles() {
  Config config;
  config.vehicle.length = 0.0;
  return config;
}

/// A car and a person.
Scan carAndPerson() {
  test::BoxWorld world;
  world.add(10.0, 3.0, 4.2, 1.8, 1.5);
  world.add(12.0, -3.0, 0.5, 0.5, 1.7);
  return world.scan(0.0, 0.0, 0.0, 0);
}

TEST(ObjectFeet, BelongToTheObject) {
  const Scan scan = carAndPerson();
  StageTimes times;
  const Config config = withoutVehicles();
  std::vector<PointRole> planes_only = selectPoints(scan.points, config.input);
  const Ground ground = extractGround(scan.points, planes_only, turnsOf(scan.points), config.ground,
                                      config.range_image, 1);
  for (std::size_t i = 0; i < planes_only.size(); ++i) {
    if (ground.is_ground[i] != 0) planes_only[i] = PointRole::kGround;
  }
  const Counts before = count(scan, planes_only);
  ASSERT_GT(before.standing.ground, 10) << "the planes must take some, or this test shows nothing";

  const Segmentation seg = segmentScan(scan, config, 1, times);
  const Counts after = count(scan, seg.roles);
  EXPECT_EQ(after.standing.ground, 0);
  // A little ground right before the boxes is lost.
  EXPECT_GT(after.floor.ground, 0.99 * before.floor.ground);
}

TEST(ObjectFeet, AKerbStaysGround) {
  test::BoxWorld world;
  world.add(10.0, 5.0, 40.0, 2.0, 0.08);  // a pavement, lower than foot_rise
  const Scan scan = world.scan(0.0, 0.0, 0.0, 0);
  StageTimes times;
  const Counts counts = count(scan, segmentScan(scan, {}, 1, times).roles);
  ASSERT_GT(counts.standing.all, 1000);
  EXPECT_GT(counts.standing.ground, 0.9 * counts.standing.all);
}

TEST(ObjectFeet, SameOnTwoThreads) {
  const Scan scan = carAndPerson();
  StageTimes times;
  EXPECT_EQ(segmentScan(scan, {}, 1, times).roles, segmentScan(scan, {}, 2, times).roles);
}

}  // namespace
}  // namespace segdf

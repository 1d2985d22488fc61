// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/mapping/instance_table.hpp"

#include <gtest/gtest.h>

namespace segdf {
namespace {

InstanceObservation observation(std::uint32_t id,
                                ObjectClass object_class,
                                std::uint32_t points,
                                bool dynamic) {
  InstanceObservation seen;
  seen.id = id;
  seen.object_class = object_class;
  seen.points = points;
  seen.dynamic = dynamic;
  seen.static_votes = dynamic ? 0 : 1;
  seen.dynamic_votes = dynamic ? 1 : 0;
  seen.size = Eigen::Vector3d(points * 0.1, 1.0, 1.0);
  return seen;
}

TEST(InstanceTable, AddsUpOverFrames) {
  InstanceTable table;
  FrameResult frame;
  frame.instances = {observation(3, ObjectClass::kUnknown, 10, false),
                     observation(8, ObjectClass::kBuilding, 5, false)};
  table.add(frame);
  frame.instances = {observation(3, ObjectClass::kHighMobility, 30, true)};
  table.add(frame);
  const auto records = table.records();
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].id, 3U);
  EXPECT_EQ(records[0].frames, 2U);
  EXPECT_EQ(records[0].points, 40U);
  EXPECT_EQ(records[0].dynamic_points, 30U);
  EXPECT_TRUE(records[0].isDynamic());
  EXPECT_EQ(records[0].object_class, ObjectClass::kHighMobility) << "class of most points";
  EXPECT_EQ(records[0].static_votes, 1U);
  EXPECT_EQ(records[0].dynamic_votes, 1U);
  EXPECT_DOUBLE_EQ(records[0].size.x(), 3.0);
  EXPECT_FALSE(records[1].isDynamic());
}

TEST(InstanceTable, WhatIsRevokedCountsAsRemoved) {
  InstanceTable table;
  FrameResult frame;
  frame.instances = {observation(3, ObjectClass::kHighMobility, 10, false)};
  frame.instances[0].reason = Reason::kVotes;
  for (int k = 0; k < 4; ++k) table.add(frame);
  Revocation revocation;
  revocation.id = 3;
  revocation.frames = 3;
  revocation.points = 30;
  table.revoke(revocation);
  EXPECT_EQ(table.records()[0].dynamic_points, 30U);
  EXPECT_TRUE(table.records()[0].isDynamic());
  EXPECT_EQ(table.records()[0].reason(), Reason::kLeft);
}

TEST(InstanceTable, VerdictNeedsHalfOfThePoints) {
  InstanceTable table;
  FrameResult frame;
  frame.instances = {observation(1, ObjectClass::kUnknown, 51, false)};
  table.add(frame);
  frame.instances = {observation(1, ObjectClass::kUnknown, 50, true)};
  table.add(frame);
  EXPECT_FALSE(table.records()[0].isDynamic());
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/evidence_log.hpp"

#include <fstream>

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

FrameResult frameWith(std::size_t index, std::uint32_t id, std::uint32_t parent) {
  InstanceObservation seen;
  seen.id = id;
  seen.parent = parent;
  seen.dynamic = parent != 0;
  seen.reason = parent != 0 ? Reason::kSplit : Reason::kVotes;
  seen.object_class = ObjectClass::kHighMobility;
  seen.points = 120;
  seen.dynamic_votes = 1;
  seen.static_votes = 2;
  seen.needed_votes = 3;
  seen.center = {1.0, -2.04, 0.5};
  seen.looks = {{4, -0.5, 0, 100}, {5, 0.3, 10, 100}, {6, 0.5, 60, 80}};
  FrameResult frame;
  frame.index = index;
  frame.instances = {seen};
  return frame;
}

class EvidenceLogTest : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "evidence.csv"; }
  test::TempFolder folder_;
};

TEST_F(EvidenceLogTest, AnInstanceAndItsPartsComeBack) {
  EvidenceLog log(file());
  log.add(frameWith(7, 3, 0));
  log.add(frameWith(8, 4, 0));
  log.add(frameWith(9, 5, 3));
  EXPECT_FALSE(std::filesystem::exists(file())) << "whole or not at all";
  log.finish();
  const auto rows = readEvidence(file(), 3);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].scan, 7U);
  EXPECT_EQ(rows[0].verdict, "static");
  EXPECT_EQ(rows[0].reason, "votes");
  EXPECT_EQ(rows[0].object_class, "high_mobility");
  EXPECT_EQ(rows[0].points, 120U);
  EXPECT_EQ(rows[0].looks, 3U);
  EXPECT_EQ(rows[0].dynamic_votes, 1U);
  EXPECT_EQ(rows[0].static_votes, 2U);
  EXPECT_EQ(rows[0].needed_votes, 3U);
  EXPECT_EQ(rows[0].center, "1.0 -2.0 0.5");
  EXPECT_EQ(rows[0].free_looks, "6:0.5:60/80") << "a look through a tenth or less is not listed";
  EXPECT_EQ(rows[1].instance, 5U);
  EXPECT_EQ(rows[1].parent, 3U);
  EXPECT_EQ(rows[1].reason, "split");
  EXPECT_TRUE(readEvidence(file(), 99).empty());
}

TEST_F(EvidenceLogTest, AnotherFileIsRefusedByName) {
  std::ofstream(file()) << "id,parent\n1,2\n";
  EXPECT_TRUE(test::contains(test::errorOf([this] { readEvidence(file(), 1); }),
                             "evidence.csv has not the columns"));
  EXPECT_TRUE(
      test::contains(test::errorOf([this] { readEvidence(folder_ / "none.csv", 1); }), "none.csv"));
}

}  // namespace
}  // namespace segdf

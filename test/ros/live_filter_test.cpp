// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/live_filter.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/nodelets/tally.hpp"

#include "ros/sample_scan.hpp"

namespace segdf {
namespace {

constexpr std::size_t kPoints = 2000;

Scan scanAt(int tenth) {
  return test::sampleScan(kPoints, 1'000'000'000'000 + std::int64_t{tenth} * 100'000'000);
}

class LiveFilterTest : public ::testing::Test {
 protected:
  LiveFilter filterFor(const std::string& sensor) {
    return LiveFilter(
        sensor, 1,
        [this](const std::string& name) {
          sensors_.push_back(name);
          return Config();
        },
        [this](const std::string& line) { lines_.push_back(line); });
  }

  std::vector<std::string> sensors_;
  std::vector<std::string> lines_;
};

TEST_F(LiveFilterTest, EveryScanComesOutOnceAndInOrder) {
  LiveFilter filter = filterFor("hdl64");
  std::vector<FrameResult> all;
  for (int k = 0; k < 5; ++k) {
    for (FrameResult& frame : filter.process(scanAt(k))) all.push_back(std::move(frame));
  }
  for (FrameResult& frame : filter.flush()) all.push_back(std::move(frame));
  ASSERT_EQ(all.size(), 5U);
  for (int k = 0; k < 5; ++k) {
    EXPECT_EQ(all[static_cast<std::size_t>(k)].scan.stamp_ns, scanAt(k).stamp_ns);
    EXPECT_EQ(all[static_cast<std::size_t>(k)].labels.size(), kPoints);
  }
  EXPECT_FALSE(filter.map().empty());
}

TEST_F(LiveFilterTest, NamedSensorIsConfiguredAtOnce) {
  const LiveFilter filter = filterFor("vlp16");
  EXPECT_EQ(sensors_, (std::vector<std::string>{"vlp16"}));
  EXPECT_TRUE(lines_.empty());
}

TEST_F(LiveFilterTest, AutoIsRecognisedOnTheFirstScanOnlyAndTold) {
  LiveFilter filter = filterFor("auto");
  EXPECT_TRUE(sensors_.empty());
  filter.process(scanAt(0));
  filter.process(scanAt(1));
  ASSERT_EQ(sensors_.size(), 1U);
  ASSERT_EQ(lines_.size(), 1U);
  EXPECT_NE(lines_[0].find(sensors_[0]), std::string::npos) << lines_[0];
}

TEST_F(LiveFilterTest, StartsAnewWhenTimeGoesBackwards) {
  LiveFilter filter = filterFor("hdl64");
  EXPECT_FALSE(filter.isBehind(scanAt(17))) << "nothing came before";
  filter.process(scanAt(17));
  EXPECT_FALSE(filter.isBehind(scanAt(17)));
  EXPECT_FALSE(filter.isBehind(scanAt(8))) << "out of order";
  EXPECT_TRUE(filter.isBehind(scanAt(3)));
  filter.flush();
  filter.restart();
  EXPECT_FALSE(filter.isBehind(scanAt(3)));
  EXPECT_TRUE(filter.map().empty());
  filter.process(scanAt(3));
  const std::vector<FrameResult> rest = filter.flush();
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].status, FrameStatus::kMapped);
}

TEST_F(LiveFilterTest, SnapshotStaysWhatItWas) {
  LiveFilter filter = filterFor("hdl64");
  EXPECT_TRUE(filter.snapshot().points.empty());
  filter.process(scanAt(1));
  filter.flush();
  const MapSnapshot snapshot = filter.snapshot();
  EXPECT_EQ(snapshot.points.size(), filter.map().size());
  EXPECT_FALSE(snapshot.points.empty());
  filter.restart();
  EXPECT_FALSE(snapshot.points.empty());
  EXPECT_TRUE(filter.snapshot().points.empty());
  EXPECT_TRUE(filter.snapshot().instances.empty());
}

TEST_F(LiveFilterTest, FlushBeforeTheFirstScanGivesNothing) {
  EXPECT_TRUE(filterFor("auto").flush().empty());
}

TEST_F(LiveFilterTest, WrongThreadsAreRefusedAtOnce) {
  EXPECT_THROW(LiveFilter("hdl64", 0, [](const std::string&) { return Config(); }, {}),
               std::invalid_argument);
}

TEST(Tally, TellsTheFirstTenthAndHundredthOfEachKind) {
  Tally tally;
  std::vector<std::size_t> told;
  for (std::size_t i = 1; i <= 150; ++i) {
    if (tally.count("empty")) told.push_back(i);
  }
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 10, 100}));
  EXPECT_TRUE(tally.count("other"));
  EXPECT_EQ(tally.of("empty"), 150U);
  EXPECT_EQ(tally.of("never"), 0U);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/pipeline/pipeline.hpp"

#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "segdf/dynamics/consensus.hpp"

#include "support/box_world.hpp"
#include "support/flushed.hpp"

namespace segdf {
namespace {

/// A street with a parked car and one that drives past, seen from a slowly moving sensor.
std::vector<Scan> makeDrive(std::size_t scans) {
  test::BoxWorld world = test::makeStreet();
  world.add(12.0, 5.0, 4.2, 1.8, 1.5);
  const std::size_t mover = world.add(-30.0, -3.0, 4.2, 1.8, 1.5);
  std::vector<Scan> drive;
  for (std::size_t k = 0; k < scans; ++k) {
    const auto t = static_cast<double>(k);
    world.moveTo(mover, -20.0 + 6.0 * t, -3.0);
    drive.push_back(
        world.scan(0.5 * t, 0.0, 0.0, static_cast<std::int64_t>(100000000 * (k + 1)), 600));
  }
  return drive;
}

std::vector<FrameResult> run(Pipeline& pipeline, const std::vector<Scan>& drive) {
  std::vector<FrameResult> results;
  const auto collect = [&results](std::vector<FrameResult> part) {
    std::move(part.begin(), part.end(), std::back_inserter(results));
  };
  for (const Scan& scan : drive) collect(pipeline.process(scan));
  collect(test::flushed(pipeline));
  return results;
}

std::vector<FrameResult> run(const std::vector<Scan>& drive,
                             const Config& config = {},
                             int threads = 1) {
  Pipeline pipeline(config, threads);
  return run(pipeline, drive);
}

TEST(Pipeline, EveryScanComesOutOnceInOrderWithALabelForEveryPoint) {
  const std::vector<Scan> drive = makeDrive(6);
  const std::vector<FrameResult> results = run(drive);
  ASSERT_EQ(results.size(), drive.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    EXPECT_EQ(results[k].index, k);
    EXPECT_EQ(results[k].scan.stamp_ns, drive[k].stamp_ns);
    EXPECT_EQ(results[k].labels.size(), drive[k].points.size());
    for (const PointLabel& label : results[k].labels) EXPECT_NE(label.state, PointState::kUnjudged);
  }
}

// A frame leaves one call after the scan that lets it: the filter works beside the segmentation.
TEST(Pipeline, InLiteralModeAFrameLeavesWhenTheWindowOfTwoIsFull) {
  const std::vector<Scan> drive = makeDrive(4);
  Config config;
  config.df.mode = FilterMode::kLiteral;
  Pipeline pipeline(config, 1);
  EXPECT_EQ(pipeline.process(drive[0]).size(), 0U);
  EXPECT_EQ(pipeline.process(drive[1]).size(), 0U);
  EXPECT_EQ(pipeline.process(drive[2]).size(), 0U);
  EXPECT_EQ(pipeline.process(drive[3]).size(), 1U);
  EXPECT_EQ(test::flushed(pipeline).size(), 3U);
  EXPECT_TRUE(test::flushed(pipeline).empty());
}

TEST(Pipeline, AJumpOfThePoseDecidesTheWindowAndStartsAnew) {
  std::vector<Scan> drive = makeDrive(8);
  for (std::size_t k = 5; k < 8; ++k) drive[k].pose.translation().y() += 3.0;
  Pipeline pipeline(Config{}, 1);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(pipeline.process(drive[k]).empty());
  const std::vector<FrameResult> before = pipeline.process(drive[5]);
  ASSERT_EQ(before.size(), 5U);
  std::vector<FrameResult> alone = run({drive.begin(), drive.begin() + 5});
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(before[k].labels, alone[k].labels) << "as if the drive had ended there";
    EXPECT_FALSE(before[k].after_jump);
  }
  const std::vector<FrameResult> after = run(pipeline, {drive.begin() + 6, drive.end()});
  ASSERT_EQ(after.size(), 3U);
  EXPECT_TRUE(after[0].after_jump);
  EXPECT_FALSE(after[1].after_jump);
  EXPECT_EQ(after[0].index, 5U);
}

TEST(Pipeline, WhatTheTakerThrowsComesOutOfFlush) {
  for (const int threads : {1, 2}) {
    Pipeline pipeline(Config{}, threads);
    for (const Scan& scan : makeDrive(4)) pipeline.process(scan);
    std::size_t taken = 0;
    const auto take = [&taken](const FrameResult& frame) {
      EXPECT_EQ(frame.index, taken);
      if (++taken == 2) throw std::runtime_error("disk full");
    };
    EXPECT_THROW(pipeline.flush(take), std::runtime_error);
    EXPECT_EQ(taken, 2U);
  }
}

TEST(Pipeline, TheDelayIsNoLongerThanTheWindowAndTheConsensus) {
  constexpr std::size_t kDelay = 3 + kFramesAround;
  const std::vector<Scan> drive = makeDrive(kDelay + 3);
  Config config;
  config.df.window = 3;
  Pipeline pipeline(config, 1);
  for (std::size_t k = 0; k < drive.size(); ++k) {
    EXPECT_EQ(pipeline.process(drive[k]).size(), k <= kDelay ? 0U : 1U);
  }
  EXPECT_EQ(test::flushed(pipeline).size(), kDelay + 1);
}

TEST(Pipeline, RemovesTheCarThatDrivesAndKeepsTheOneThatIsParked) {
  std::size_t mover_points = 0;
  std::size_t mover_removed = 0;
  for (const FrameResult& result : run(makeDrive(7))) {
    for (std::size_t i = 0; i < result.labels.size(); ++i) {
      const Eigen::Vector3d x = result.scan.pose * result.scan.points[i].position().cast<double>();
      if (x.z() < 0.3) continue;  // wheels' height: may be ground
      if (std::abs(x.x() - 12.0) < 2.2 && std::abs(x.y() - 5.0) < 1.0) {
        EXPECT_TRUE(isKept(result.labels[i].state)) << "parked, scan " << result.index;
      }
      if (std::abs(x.y() + 3.0) < 1.0) {
        ++mover_points;
        mover_removed += result.labels[i].state == PointState::kDynamic ? 1 : 0;
      }
    }
  }
  // 6 m a scan is more than the car's length, so it is never found again where it was. Left over
  // are clusters too small to be instances and what counts as ground of a car right beside the
  // sensor.
  EXPECT_GT(static_cast<double>(mover_removed), 0.9 * static_cast<double>(mover_points));
}

TEST(Pipeline, SameLabelsOnOneAndTwoThreadsAndAgain) {
  const std::vector<Scan> drive = makeDrive(5);
  const auto one = run(drive, {}, 1);
  for (int threads : {1, 2}) {
    const auto other = run(drive, {}, threads);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].labels, other[k].labels);
  }
}

TEST(Pipeline, InstancesCarryTheLabelsIds) {
  for (const FrameResult& result : run(makeDrive(4))) {
    std::set<std::uint32_t> listed;
    std::size_t points = 0;
    for (const InstanceObservation& seen : result.instances) {
      EXPECT_TRUE(listed.insert(seen.id).second);
      points += seen.points;
    }
    std::size_t labelled = 0;
    for (const PointLabel& label : result.labels) {
      if (label.instance == 0) continue;
      ++labelled;
      EXPECT_EQ(listed.count(label.instance), 1U);
    }
    EXPECT_EQ(points, labelled);
  }
}

TEST(Pipeline, AParkedCarKeepsItsIdOverTheDrive) {
  std::set<std::uint32_t> ids;
  for (const FrameResult& result : run(makeDrive(6))) {
    for (const InstanceObservation& seen : result.instances) {
      if (std::hypot(seen.center.x() - 12.0, seen.center.y() - 5.0) < 1.5) ids.insert(seen.id);
    }
  }
  EXPECT_EQ(ids.size(), 1U);
}

TEST(Pipeline, ScansThatCannotBeUsedComeBackInTheirTurnUnjudged) {
  std::vector<Scan> drive = makeDrive(5);
  drive[1].points.clear();
  drive[2].pose.linear().setZero();
  drive[3].stamp_ns = drive[0].stamp_ns;
  const auto results = run(drive);
  ASSERT_EQ(results.size(), 5U);
  EXPECT_EQ(results[0].status, FrameStatus::kMapped);
  EXPECT_EQ(results[1].status, FrameStatus::kEmpty);
  EXPECT_EQ(results[2].status, FrameStatus::kInvalidPose);
  EXPECT_EQ(results[3].status, FrameStatus::kTimeBackwards);
  EXPECT_EQ(results[4].status, FrameStatus::kMapped);
  for (std::size_t k : {2U, 3U}) {
    ASSERT_EQ(results[k].labels.size(), drive[k].points.size());
    for (const PointLabel& label : results[k].labels) EXPECT_EQ(label, PointLabel{});
  }
}

TEST(Pipeline, NaNPointsAreCountedAndLeftUnjudged) {
  std::vector<Scan> drive = makeDrive(3);
  for (Scan& scan : drive) scan.points[7].y = std::nanf("");
  for (const FrameResult& result : run(drive)) {
    EXPECT_EQ(result.non_finite_points, 1U);
    EXPECT_EQ(result.labels[7].state, PointState::kUnjudged);
  }
}

TEST(Pipeline, FlushForgetsThePastButIdsAndNumbersGoOn) {
  const std::vector<Scan> drive = makeDrive(3);
  Pipeline pipeline(Config{}, 1);
  const auto first = run(pipeline, drive);
  const auto second = run(pipeline, drive);  // its stamps start anew
  ASSERT_EQ(second.size(), 3U);
  EXPECT_EQ(second[0].index, 3U);
  std::set<std::uint32_t> old_ids;
  for (const auto& result : first) {
    for (const auto& seen : result.instances) old_ids.insert(seen.id);
  }
  for (const auto& seen : second[0].instances) EXPECT_EQ(old_ids.count(seen.id), 0U);
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < first[k].labels.size(); ++i) {
      EXPECT_EQ(first[k].labels[i].state, second[k].labels[i].state);
    }
  }
}

TEST(Pipeline, RefusesBadParametersByName) {
  Config config;
  config.df.thre_occu = 1.5;
  EXPECT_THROW(Pipeline(config, 1), std::invalid_argument);
  EXPECT_THROW(Pipeline(Config{}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace segdf

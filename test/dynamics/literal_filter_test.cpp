// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/literal_filter.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "support/box_world.hpp"
#include "support/key_frames.hpp"

namespace segdf {
namespace {

using test::makeKeyFrame;
using test::segmentAt;

class LiteralFilterTest : public ::testing::Test {
 protected:
  /// Runs the filter over the pair and makes both frames final.
  void run(const Scan& first, const Scan& second) {
    before_ = makeKeyFrame(first, config_);
    after_ = makeKeyFrame(second, config_);
    filter_.observe({before_.get()});
    filter_.observe({before_.get(), after_.get()});
    filter_.decide({before_.get(), after_.get()}, 2);
  }

  /// A street with a car at (8, 3) that moves by dx between two scans from the same place.
  void moveCar(double dx) {
    test::BoxWorld world = test::makeStreet();
    const std::size_t car = world.add(8.0, 3.0, 4.2, 1.8, 1.5);
    const Scan first = world.scan(0.0, 0.0, 0.0, 1);
    world.moveTo(car, 8.0 + dx, 3.0);
    run(first, world.scan(0.0, 0.0, 0.0, 2));
  }

  const Instance& instanceAt(const KeyFrame& frame, double x, double y) const {
    return frame.instances[segmentAt(frame, x, y)];
  }

  Config config_;
  IdSource ids_;
  LiteralFilter filter_{config_, ids_, 1};
  std::unique_ptr<KeyFrame> before_;
  std::unique_ptr<KeyFrame> after_;
};

TEST_F(LiteralFilterTest, HighDynamicACarThatLeftIsRemovedWhole) {
  moveCar(15.0);
  const Instance& car = instanceAt(*before_, 8.0, 3.0);
  EXPECT_TRUE(car.dynamic);
  EXPECT_EQ(car.dynamic_votes, 1U);
}

TEST_F(LiteralFilterTest, HighStaticAParkedCarIsKeptAndKeepsItsId) {
  moveCar(0.0);
  const Instance& car = instanceAt(*before_, 8.0, 3.0);
  EXPECT_FALSE(car.dynamic);
  EXPECT_EQ(car.static_votes, 1U);
  EXPECT_EQ(instanceAt(*after_, 8.0, 3.0).id, car.id);
}

TEST_F(LiteralFilterTest, NothingStaticIsRemovedInAStillScene) {
  moveCar(0.0);
  for (const KeyFrame* frame : {before_.get(), after_.get()}) {
    for (const Instance& instance : frame->instances) EXPECT_FALSE(instance.dynamic);
  }
}

TEST_F(LiteralFilterTest, SplitRemovesThePartThatIsGone) {
  moveCar(3.6);  // 0.6 m of 4.2 m are covered again
  std::size_t removed = 0;
  for (std::size_t s = 0; s < before_->instances.size(); ++s) {
    const Instance& part = before_->instances[s];
    if (!part.dynamic) continue;
    ++removed;
    EXPECT_NE(part.parent, 0U);
    EXPECT_NE(part.parent, part.id);
    const auto rest = std::find_if(before_->instances.begin(), before_->instances.end(),
                                   [&](const Instance& i) { return i.id == part.parent; });
    ASSERT_NE(rest, before_->instances.end());
    EXPECT_FALSE(rest->dynamic);
    EXPECT_GT(before_->seg.segments[s].points.size(), 50U);
  }
  EXPECT_EQ(removed, 1U);
}

TEST_F(LiteralFilterTest, TheLastFrameIsJudgedAgainstTheOneBefore) {
  moveCar(15.0);
  EXPECT_TRUE(instanceAt(*after_, 23.0, 3.0).dynamic);
  EXPECT_TRUE(after_->judged);
}

TEST_F(LiteralFilterTest, AnExcludedClassIsNeverRemoved) {
  test::BoxWorld world = test::makeStreet();
  const Scan with_wall = world.scan(0.0, 0.0, 0.0, 1);
  test::BoxWorld empty;
  empty.add(30.0, 0.0, 1.0, 1.0, 1.0);
  run(with_wall, empty.scan(0.0, 0.0, 0.0, 2));
  for (std::size_t s = 0; s < before_->instances.size(); ++s) {
    if (before_->seg.segments[s].object_class == ObjectClass::kBuilding) {
      EXPECT_FALSE(before_->instances[s].dynamic);
    }
  }
}

TEST_F(LiteralFilterTest, IdsAreUniqueWithinAFrameAndNeverZero) {
  moveCar(1.0);
  for (const KeyFrame* frame : {before_.get(), after_.get()}) {
    std::set<std::uint32_t> seen;
    for (const Instance& instance : frame->instances) {
      EXPECT_NE(instance.id, 0U);
      EXPECT_TRUE(seen.insert(instance.id).second) << instance.id;
    }
  }
}

TEST_F(LiteralFilterTest, ASingleFrameIsStatic) {
  before_ = makeKeyFrame(test::makeStreet().scan(0.0, 0.0, 0.0, 1), config_);
  filter_.observe({before_.get()});
  filter_.decide({before_.get()}, 0);
  for (const Instance& instance : before_->instances) EXPECT_FALSE(instance.dynamic);
}

}  // namespace
}  // namespace segdf

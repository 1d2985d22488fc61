// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/swept_volumes.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr float kMargin = 0.01F;  // metres: a centimetre of rounding

/// Frames of a sensor that goes 1 m along x in each, turned by 90 degrees to the left, and sees two
/// boxes 2 m before it: the left one goes, the right one stands.
class SweptVolumes : public ::testing::Test {
 protected:
  void judgeFrames(std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      frames_.push_back(std::make_unique<KeyFrame>());
      KeyFrame& frame = *frames_.back();
      frame.scan.pose = Eigen::Translation3d(static_cast<double>(k), 0.0, 0.0) *
                        Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitZ());
      addBox(frame, {2.0F, 1.0F, 0.0F}).dynamic = true;
      addBox(frame, {2.0F, -2.0F, 0.0F});
      window_.push_back(&frame);
      exchangeSweptVolumes(window_, k);
    }
  }

  /// 1 m on each side, the corner that is nearest and lowest in the sensor frame.
  static Instance& addBox(KeyFrame& frame, const Eigen::Vector3f& corner) {
    Segment segment;
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector3i step(k & 1, (k >> 1) & 1, k >> 2);
      const Eigen::Vector3f x = corner + step.cast<float>();
      Point p;
      p.x = x.x();
      p.y = x.y();
      p.z = x.z();
      segment.points.push_back(static_cast<std::uint32_t>(frame.scan.points.size()));
      frame.scan.points.push_back(p);
      segment.bounds.extend(x);
    }
    frame.seg.segments.push_back(segment);
    return frame.instances.emplace_back();
  }

  /// Whether something moved at a place (sensor frame of frame 0) in a frame around frame 0.
  bool isSwept(const Eigen::Vector3f& place) {
    for (const Volume& volume : frames_[0]->swept) {
      if (volume.contains(place, kMargin)) return true;
    }
    return false;
  }

  std::vector<std::unique_ptr<KeyFrame>> frames_;
  Window window_;
};

TEST_F(SweptVolumes, AFrameKnowsWhereOthersSawSomethingMove) {
  judgeFrames(3);
  // The sensor's x is the map's y: from frame to frame the box is 1 m farther to its right.
  EXPECT_TRUE(isSwept({2.5F, 0.5F, 0.5F})) << "in the next frame";
  EXPECT_TRUE(isSwept({2.5F, -0.5F, 0.5F})) << "in the one after it";
  EXPECT_FALSE(isSwept({2.5F, 1.5F, 0.5F})) << "in its own frame only";
  EXPECT_FALSE(isSwept({2.5F, -2.5F, 0.5F})) << "what stands";
  EXPECT_FALSE(isSwept({2.5F, 0.5F, 1.5F})) << "above";
}

TEST_F(SweptVolumes, FiveFramesToEachSideAreAsked) {
  judgeFrames(13);
  EXPECT_EQ(frames_[0]->swept.size(), 5U);
  EXPECT_EQ(frames_[6]->swept.size(), 10U);
  EXPECT_EQ(frames_[10]->swept.size(), 7U);
  EXPECT_TRUE(isSwept({2.5F, -3.5F, 0.5F})) << "in frame 5";
  EXPECT_FALSE(isSwept({2.5F, -4.5F, 0.5F})) << "in frame 6";
}

TEST_F(SweptVolumes, AFrameWithoutMoversTellsNothing) {
  judgeFrames(2);
  frames_[1]->instances[0].dynamic = false;
  frames_[0]->swept.clear();
  exchangeSweptVolumes(window_, 1);
  EXPECT_TRUE(frames_[0]->swept.empty());
}

}  // namespace
}  // namespace segdf

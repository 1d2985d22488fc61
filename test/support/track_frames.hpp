// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/track_vote.hpp"

namespace segdf::test {

inline constexpr std::uint32_t kPoints = 20;
inline const Eigen::Vector3f kCar(4.2F, 1.8F, 1.5F);

/// Key frames with one instance each, all of one id, and with what others are said to have seen.
class TrackVote : public ::testing::Test {
 protected:
  KeyFrame& add(double x, const Eigen::Vector3f& size, double step) {
    auto frame = std::make_unique<KeyFrame>();
    frame->index = frames_.size();
    Segment segment;
    segment.points.resize(kPoints);
    segment.object_class = ObjectClass::kHighMobility;
    segment.box.center.x() = static_cast<float>(x);
    segment.box.size = size;
    frame->seg.segments.push_back(segment);
    frame->instances.resize(1);
    frame->instances[0].id = 7;
    frame->evidence = std::make_shared<FrameEvidence>(prepareEvidence(KeyFrame{}, config_));
    frame->evidence->step = step;
    frame->evidence->time = time_ += step;
    frame->evidence->votes.resize(1);
    window_.push_back(frame.get());
    frames_.push_back(std::move(frame));
    return *frames_.back();
  }

  /// Three frames saw through it.
  KeyFrame& addMoving(double x, double step, const Eigen::Vector3f& size = kCar) {
    KeyFrame& frame = add(x, size, step);
    frame.evidence->votes[0].assign(3, {0, 0.3F, kPoints, 0, true});
    return frame;
  }

  /// Three frames a second away found it again. @param scan of the first of these
  KeyFrame& addStanding(double x, double step, std::size_t scan = 100) {
    KeyFrame& frame = add(x, kCar, step);
    for (std::size_t k = 0; k < 3; ++k) {
      frame.evidence->votes[0].push_back({scan + k, 1.0F, 0, kPoints, true});
    }
    return frame;
  }

  /// As its votes do.
  static void makeDynamic(KeyFrame& frame) {
    frame.instances[0].dynamic = true;
    frame.instances[0].reason = Reason::kVotes;
  }

  /// Eight scans of motion that have left the window.
  void moveThroughTheWindow(TrackBook& tracks) {
    for (int k = 0; k < 8; ++k) {
      addMoving(1.0 * k, 0.1);
      makeDynamic(*window_.back());
      tracks.note(*window_.back());
    }
    window_.clear();
  }

  /// The verdict by track on the newest frame.
  bool goes() {
    TrackBook(config_).propagate(window_, window_.size() - 1);
    return frames_.back()->instances[0].dynamic;
  }

  DynamicConfig config_;
  std::vector<std::unique_ptr<KeyFrame>> frames_;
  Window window_;
  double time_ = 0.0;
};

}  // namespace segdf::test

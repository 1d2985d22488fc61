// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/config.hpp"
#include "segdf/core/frame_result.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/dynamics/visibility_image.hpp"

namespace segdf {

/// Where things that can move stood when their frames left the window. Later key frames look there:
/// what has left by then (the queue at the lights, a car that was parked when the street was seen
/// first) is revoked in all frames in which it stood. Removal that comes late, where the window is
/// too short to see both (docs/dynamic_filter.md). Memory: the latest kStands places, a few
/// kilobytes each, however long the drive.
class PlaceMemory {
 public:
  explicit PlaceMemory(const DynamicConfig& config) : config_(config) {}

  /// Remembers what stands in a frame that is decided and leaves the window.
  void note(const KeyFrame& frame);

  /// Lets the newest key frame look at the places around it. Its relative pose to the frame that
  /// saw a place best is refined and measured as for any other pair.
  void look(const KeyFrame& newest);

  /// What has been revoked since the last call, in the order of finding.
  std::vector<Revocation> takeRevocations();

  /// Forgets all places: a new session, or poses that jumped.
  void forget();

 private:
  /// A frame from which places are remembered.
  struct View {
    double time = 0.0;  ///< seconds
    Pose pose;
    std::vector<Eigen::Vector3f> registration_points;
  };
  /// Something that stands in one place, under one id or several.
  struct Stand {
    std::vector<Revocation> runs;  ///< what would be revoked: an entry for each id in turn
    Eigen::Vector3d center;        ///< of its box, map frame, metres
    Eigen::Vector3f size;          ///< of its box, metres
    double next_look = 0.0;        ///< seconds
    int free_looks = 0;            ///< in a row
    std::size_t points = 0;        ///< where it was seen best
    std::shared_ptr<const View> view;
    Eigen::MatrixX3f places;  ///< some of its points in the view's sensor frame, metres
  };

  /// What the newest key frame says of a place.
  struct Answer {
    std::size_t stand = 0;
    bool free = false;   ///< seen through; else found again
    bool fresh = false;  ///< asked now
  };

  Stand* standOf(const KeyFrame& frame, std::size_t segment, const Eigen::Vector3d& center);
  static View viewOf(const KeyFrame& frame);
  void remember(const KeyFrame& frame, std::size_t segment, std::shared_ptr<const View>& view);
  /// Answers of the places around, those that were asked a short while ago included.
  std::vector<Answer> askAround(const KeyFrame& newest);
  /// FREE, HIT or UNKNOWN, of the place as a whole.
  VolumetricState stateOf(const Stand& stand,
                          const KeyFrame& newest,
                          const Pose& newest_T_view) const;
  /// True when most of what was seen at the same time is found again: else it is the poses that do
  /// not fit, after a long way without a loop closure.
  bool isTrusted(const Answer& answer, const std::vector<Answer>& answers) const;

  DynamicConfig config_;
  std::vector<Stand> stands_;  ///< in the order in which they were first seen
  std::vector<Revocation> revoked_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Verdicts of neighbouring key frames on one place (method.md 6.6, several frames decide). The
/// evidence of a frame hangs on which others it was compared with: of a lorry that stands beside
/// the ego, and goes with its track for seconds, one scan has no look that tells it from what is
/// parked, and in another a part of it seems to stand. What most frames around remove goes there,
/// too. The reverse is not done: it brings nothing.
class Consensus {
 public:
  /// Notes the verdicts on a key frame. @pre frames come in the order of time
  void note(const KeyFrame& frame);

  /// Makes dynamic what stands in the frame, and goes in seven tenths of the frames around that
  /// have its track there: six at least, one after it among them. A part that was found to stand is
  /// looked for as its instance, with all parts. A frame in which something else stands there says
  /// that it stands. Forgets what no later frame asks for.
  /// @pre this frame and, but at the end, kFramesAround after it have been noted
  void apply(KeyFrame& frame);

 private:
  /// An instance of a frame.
  struct View {
    std::uint32_t track = 0;    ///< its id, or that of which it is a part
    Eigen::AlignedBox2d place;  ///< seen from above, map frame, metres
    std::size_t points = 0;
    bool dynamic = false;
  };
  struct FrameViews {
    std::size_t scan = 0;
    std::vector<View> views;
    std::vector<std::uint32_t> moving;  ///< tracks of which anything goes, ascending
  };
  /// What a frame says of a view's place.
  enum class Say : std::uint8_t { kNothing, kStands, kGoes };

  static FrameViews viewsOf(const KeyFrame& frame);
  /// True when the other view is of another object, which was found to stand: the track comes from
  /// it, or goes on to it.
  static bool standsInPlaceOf(const View& view, const View& other);
  static Say say(const FrameViews& frame, const View& view);
  bool goes(std::size_t here, const View& view) const;

  std::deque<FrameViews> frames_;  ///< oldest first
};

}  // namespace segdf

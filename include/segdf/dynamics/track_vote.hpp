// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"

namespace segdf {

/// Tracks (method.md 6.6): the instances of one id. What the votes leave static becomes dynamic
/// when its track was proven to move: by at least two members of its size in the window, or for
/// 0.75 s, in the past too, by members of which it may be a part, or which may be parts of it, and
/// away from here. The motion of what it was a part of counts, too. What was itself found again
/// over and over goes only when df.semi_static says that what moved at any time goes (a car that
/// stops at lights), and its track moved for 0.75 s so, by members that are no longer than it is,
/// nor a walker's, and either moved before, or some scan saw through the segment since:
/// what leaves opens its place. Nothing goes where it was found again by frames in which the track
/// moved elsewhere, or on the other side of these in time: then another object stands here, and the
/// id has passed on to it. What the votes make dynamic is restored when hardly any of many members
/// of its track are (compensation). Memory: tracks that have left the window, and that nothing can
/// continue any more, are forgotten.
class TrackBook {
 public:
  /// An instance that the votes made dynamic.
  struct Proof {
    std::size_t scan = 0;                              ///< running number
    Eigen::Vector3f size = Eigen::Vector3f::Zero();    ///< of its box, metres
    Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of its box in the map frame, metres
    double seconds = 0.0;                              ///< of motion that it stands for
    double speed = 0.0;                                ///< of its centre, seen from above, m/s
  };
  explicit TrackBook(const DynamicConfig& config) : config_(config) {}

  /// Makes instances of the frame dynamic, or static again, by their tracks. Verdicts by votes are
  /// made for all frames of the window; those of frames still gathering evidence count as they are.
  void propagate(const Window& window, std::size_t position);

  /// Notes what was decided on the frame that leaves.
  void note(const KeyFrame& frame);

 private:
  /// What the window holds of one id.
  struct Track {
    std::size_t members = 0;
    std::vector<Proof> inherited;  ///< from what it was a part of
    std::vector<Proof> proofs;     ///< members that the votes make dynamic so far
  };
  /// What so many votes make of an instance.
  struct Judgement {
    std::size_t votes = ~std::size_t{0};  ///< nobody has so many: not judged yet
    bool dynamic = false;
  };

  /// What decided frames told of an id.
  struct Past {
    std::vector<Proof> proofs;   ///< its own and inherited ones, in the order of their scans
    double seen = 0.0;           ///< when it was last, seconds
    int apart = 0;               ///< instances that stood apart from what moved
    std::size_t last_apart = 0;  ///< scan of the last of these
  };

  /// Gives what a frame's new ids came off to them.
  void inherit(const KeyFrame& frame);
  /// Of the ids that a frame has.
  std::map<std::uint32_t, Track> tracksOf(const KeyFrame& frame, const Window& window);
  bool isDynamic(const KeyFrame& frame, std::size_t segment);
  /// Takes out what moved before the id passed on to another object.
  void forgetOthers(std::uint32_t id, std::vector<Proof>& proofs) const;
  /// Proofs of scans before the window's first.
  std::vector<Proof> pastOf(std::uint32_t id, const KeyFrame& first) const;
  bool moves(const KeyFrame& frame,
             std::size_t segment,
             const std::vector<Proof>& past,
             const std::vector<Proof>& present);

  DynamicConfig config_;
  std::map<std::uint32_t, Past> past_;  ///< of what may yet be seen again
  /// By the frame's number, for each segment: votes only ever come on top of others.
  std::map<std::size_t, std::vector<Judgement>> judged_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/dynamics/motion_proof.hpp"

namespace segdf {

/// Tracks (method.md 6.6): the instances of one id. What the votes leave static becomes dynamic
/// when its track was proven to move: by at least two members of its size in the window, or for
/// 0.75 s, in the past too, by members of which it may be a part, or which may be parts of it. The
/// motion of what it was a part of counts, too, and that of what moved and ended where it began to
/// move. What was itself found again over and over goes only when df.semi_static says that what
/// moved at any time goes (a car that stops at lights), and its track moved for 0.75 s so, by
/// members that are no longer than it is, and either moved before, or some scan saw through the
/// segment since: what leaves opens its place. Motion before the segment's scan, or after it, does
/// not count where scans of that side found it here while the track was elsewhere, or from beyond
/// motion elsewhere: then another object stands here, and the id has passed on to it. What the
/// votes make dynamic is restored when hardly any of many members of its track are (compensation).
/// What can move and stands where nothing was 5 s before came, whoever saw it do so: it goes, but
/// proves no motion. What moved elsewhere at the same size is marked as whole. Memory: tracks that
/// have left the window, and that nothing can continue any more, are forgotten.
class TrackBook {
 public:
  explicit TrackBook(const DynamicConfig& config) : config_(config) {}

  /// Makes instances of the frame dynamic, or static again, by their tracks. Verdicts by votes are
  /// made for all frames of the window; those of frames still gathering evidence count as they are.
  void propagate(const Window& window, std::size_t position);

  /// Notes what was decided on the frame that leaves, once what stands has been taken out of what
  /// moves.
  void note(const KeyFrame& frame);

 private:
  /// What the window holds of one id.
  struct Track {
    std::size_t members = 0;
    MotionProofs inherited;  ///< from what it was a part of
    MotionProofs proofs;     ///< members that the votes make dynamic so far
  };
  /// What so many votes make of an instance.
  struct Judgement {
    std::size_t votes = ~std::size_t{0};  ///< nobody has so many: not judged yet
    bool dynamic = false;
  };

  /// What decided frames told of an id.
  struct Past {
    MotionProofs proofs;         ///< its own and inherited ones
    MotionProofs views;          ///< the same, moving or not, of as many scans as a window has
    std::size_t born = 0;        ///< scan that had it first
    double born_at = 0.0;        ///< its time, seconds
    double seen = 0.0;           ///< when it was last, seconds
    bool moved = false;          ///< then, by the votes, and has no heir yet
    bool stood = false;          ///< at some time, found again where it was
    int apart = 0;               ///< instances that stood apart from what moved before
    std::size_t last_apart = 0;  ///< scan of the last of these
  };

  /// Gives a frame's new ids what those they came off did, and what moved and has ended to its
  /// heir.
  void inherit(const KeyFrame& frame);
  /// The id in the frame that goes on with one that moved and has ended, 0 = none: the nearest
  /// within 2.5 m, as seen from above, of those that the votes make dynamic, that came after it,
  /// and that were not there beside it for long and have not stood.
  std::uint32_t heirOf(const Past& ended, const KeyFrame& frame);
  /// Of the ids that a frame has.
  std::unordered_map<std::uint32_t, Track> tracksOf(const KeyFrame& frame, const Window& window);
  bool isDynamic(const KeyFrame& frame, std::size_t segment);
  /// Takes out what moved before the id passed on to another object.
  void forgetOthers(std::uint32_t id, MotionProofs& proofs) const;
  /// Proofs of scans before the window's first.
  MotionProofs pastOf(std::uint32_t id, const KeyFrame& first) const;
  /// Where an id was, moving or not, by the frames of the window and as many before it.
  MotionProofs viewsOf(std::uint32_t id, const Window& window) const;
  bool moves(const KeyFrame& frame,
             std::size_t segment,
             MotionProofs proofs,
             const MotionProofs& present,
             const Window& window);
  /// Without those of another object, from which the segment stands apart.
  MotionProofs ownProofs(const KeyFrame& frame,
                         std::size_t segment,
                         const MotionProofs& proofs,
                         bool parked,
                         const Window& window);

  DynamicConfig config_;
  std::map<std::uint32_t, Past> past_;  ///< of what may yet be seen again
  /// By the frame's number, for each segment: votes only ever come on top of others.
  std::map<std::size_t, std::vector<Judgement>> judged_;
};

}  // namespace segdf

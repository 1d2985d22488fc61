// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/label.hpp"
#include "segdf/core/scan.hpp"

namespace segdf {

/// What became of a scan. All but kMapped leave every point unjudged, and the scan out of the map.
enum class FrameStatus : std::uint8_t {
  kMapped,         ///< a key frame: every point within range is judged
  kNotKeyFrame,    ///< between two key frames (input.keyframe_distance)
  kEmpty,          ///< no usable point
  kInvalidPose,    ///< not finite, or no rotation
  kTimeBackwards,  ///< stamp not after the last accepted scan's
};

std::string toString(FrameStatus status);

/// What decided on an instance in one frame (method.md 6.2, 6.5, 6.6).
enum class Reason : std::uint8_t {
  kNoEvidence,   ///< no other frame told anything: kept
  kAssociation,  ///< literal mode: neighbours and occupancy
  kVotes,        ///< enough, or not enough, frames saw through it
  kLongLook,     ///< one clear vote: where there are few (the ends of a drive), or of long before
  kDeparture,    ///< it is elsewhere, and where it was is empty
  kTrack,        ///< its track moves
  kRestored,     ///< the votes made it dynamic, but hardly any other member of its track
  kSplit,        ///< the moved part of a standing instance
  kKept,         ///< the standing part of a moved instance
  kEnclosed,     ///< lies inside a moved instance, and was hardly found again
  kConsensus,    ///< most key frames around it remove what is in its place
  kLeft,         ///< it stood, and later scans saw through its place (Revocation)
};
constexpr std::size_t kReasons = 12;

/// Lower-case name: "no_evidence", "association", "votes", "long_look", "departure", "track",
/// "restored", "split", "kept", "enclosed", "consensus", "left".
std::string toString(Reason reason);

/// What another key frame says of an instance.
struct Look {
  std::size_t scan = 0;    ///< running number of the other scan
  double seconds = 0.0;    ///< to it, negative into the past
  std::uint32_t free = 0;  ///< points seen through
  std::uint32_t seen = 0;  ///< points seen through or found again
};

/// Instance as seen in one frame: what rviz shows and instances.csv adds up.
struct InstanceObservation {
  std::uint32_t id = 0;      ///< global instance id, 1 and up
  std::uint32_t parent = 0;  ///< instance from which it was split, 0 = none
  ObjectClass object_class = ObjectClass::kUnknown;
  bool dynamic = false;
  bool fused = false;  ///< made of several clusters (Algorithm 2, line 18)
  std::uint32_t points = 0;
  std::uint32_t static_votes = 0;   ///< HS votes (Algorithm 2, lines 12 and 17)
  std::uint32_t dynamic_votes = 0;  ///< HD votes (lines 10 and 14)
  std::uint32_t needed_votes = 0;   ///< HD votes that make it dynamic
  Reason reason = Reason::kNoEvidence;
  std::vector<Look> looks;                           ///< of the frames that saw enough of it
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< box centre in the map frame, metres
  Eigen::Vector3d size = Eigen::Vector3d::Zero();    ///< length >= width, height; metres
  double yaw = 0.0;                                  ///< of the length axis in the map frame, rad
  /// Of the box's centre along its track, map frame, m/s; zero where it was not followed.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

/// What stood in earlier frames and has left since (docs/dynamic_filter.md): the points that carry
/// its id there, and were kept, are dynamic after all.
struct Revocation {
  std::uint32_t id = 0;
  std::size_t first = 0;   ///< running number of the first scan in which it stood
  std::size_t last = 0;    ///< and of the last
  std::size_t frames = 0;  ///< in which it was seen there
  std::size_t points = 0;  ///< of all of these together
  ObjectClass object_class = ObjectClass::kUnknown;  ///< in the last of them
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of its box in the map frame, metres
};

/// Seconds spent in each stage on one frame. For reports only; nothing is decided by it.
struct StageTimes {
  double ground = 0.0;
  double normals = 0.0;
  double clustering = 0.0;
  double classification = 0.0;
  double dynamics = 0.0;
};

/// What the pipeline says of one scan.
struct FrameResult {
  std::size_t index = 0;  ///< running number of the scan, from 0, as given to Pipeline::process
  FrameStatus status = FrameStatus::kMapped;
  bool after_jump = false;                     ///< its pose jumped: the window started anew with it
  Scan scan;                                   ///< as given
  std::vector<PointLabel> labels;              ///< one for each point of `scan`
  std::vector<InstanceObservation> instances;  ///< ordered by id
  std::vector<Revocation> revoked;             ///< of frames that came out earlier
  /// Median point-to-plane distance to the previous key frame, metres; NaN when not measurable.
  double pose_misfit = 0.0;
  std::size_t non_finite_points = 0;  ///< NaN or infinite coordinates, left unjudged
  StageTimes times;
};

}  // namespace segdf

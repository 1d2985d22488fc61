// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/Pose.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Header.h>

#include "segdf/core/frame_result.hpp"
#include "segdf/core/scan.hpp"
#include "segdf/mapping/map_point.hpp"

/// Between messages and plain types. Pure functions: nodelet and offline runner get the same scan
/// from the same messages. Headers never go through PCL, whose stamps are cut to microseconds.
namespace segdf {

/// A cloud and the pose that belongs to it as a scan.
///
/// Both of LIO-SAM's forms are taken. A cloud in the odometry's frame (`frame_id` equal) is brought
/// back to the sensor by the pose; any other is in the sensor frame. All points stay, in their
/// order, NaN included. Fields: x y z (float32, metres), intensity (any number); optional `ring`,
/// and the time as `time`, `t` or `timestamp`: uint32 are nanoseconds and floats are seconds after
/// the stamp, but a float64 `timestamp` counts from the epoch. Without `ring`, rings are recovered
/// from the order of the points. The pose is that of toPose().
///
/// @param topic names the cloud in messages
/// @throws IoError if a field is missing or its type cannot be used, or the sizes do not fit each
/// other
Scan toScan(const sensor_msgs::PointCloud2& cloud,
            const nav_msgs::Odometry& odometry,
            const std::string& topic = "cloud");

/// A quaternion that is not of length 1 gives a pose that isValidPose() refuses.
Pose toPose(const geometry_msgs::Pose& message);

/// Which points of a frame are published.
enum class CloudKind {
  kStatic,    ///< ground, static instances and noise: what goes into the map
  kDynamic,   ///< what was removed
  kLabelled,  ///< every input point in input order, those not judged included
};

/// Points in the map frame with x y z intensity (float32), rgb (packed in a float32), label
/// (uint32: SemanticKITTI-style class of core/semantic_kitti.hpp) and instance (uint32: the whole
/// id).
sensor_msgs::PointCloud2 toCloud(const std::vector<MapPoint>& points,
                                 const std_msgs::Header& header);

/// The same of one frame, with the stamp of its scan.
sensor_msgs::PointCloud2 toCloud(const FrameResult& frame,
                                 const std::string& frame_id,
                                 CloudKind kind);

/// Header with the stamp of the scan.
std_msgs::Header toHeader(const Scan& scan, const std::string& frame_id);

}  // namespace segdf

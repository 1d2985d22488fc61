// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"
#include "segdf/dynamics/plane_map.hpp"

namespace segdf {

/// Relative pose of a pair of scans and how well it fits.
struct PairPose {
  Pose to_T_from = Pose::Identity();
  double quality = 0.0;  ///< share of the points within 30 m that meet a plane within 0.1 m, 0..1
  bool refined = false;  ///< false: the given pose was as good
};

/// Refines the relative pose of one pair by robust point-to-plane registration (method.md 6.12, 1
/// and 2): Geman-McClure kernel from 0.5 m down to 0.08 m, at most 20 steps. The result is taken
/// only if it is no farther than 1.5 m and 0.06 rad from the given pose and fits better by 0.02;
/// else the given pose comes back with its own quality.
/// @param source points of the scan `from`, thinned, in its sensor frame, metres
/// @param target planes of the scan `to`, in its sensor frame
PairPose refinePair(const Pose& to_T_from,
                    const std::vector<Eigen::Vector3f>& source,
                    const PlaneMap& target);

}  // namespace segdf

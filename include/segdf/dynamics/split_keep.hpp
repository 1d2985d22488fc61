// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/dynamics/evidence.hpp"
#include "segdf/dynamics/frame.hpp"
#include "segdf/segmentation/curved_voxels.hpp"

namespace segdf {

/// Split (method.md 6.5): takes the parts of static instances that others saw through out of them
/// and makes them dynamic instances. Parts are connected and have at least df.split_min points.
/// @param by_point evidenceByPoint(frame)
void splitMoved(KeyFrame& frame,
                const std::vector<PlaceEvidence>& by_point,
                const Config& config,
                const CurvedGrid& grid,
                IdSource& ids);

/// Keep (method.md 6.5): takes the parts of dynamic instances that others found again, and never
/// saw through, out of them and makes them static instances. Parts are connected, have at least
/// df.keep_min points, and lie beside what moved: within its footprint only its own parts can be,
/// found again where the next ones of a row of vehicles came by.
/// @param by_point evidenceByPoint(frame)
void keepStanding(KeyFrame& frame,
                  const std::vector<PlaceEvidence>& by_point,
                  const Config& config,
                  const CurvedGrid& grid,
                  IdSource& ids);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Recovers the lasers of a ring-major scan from the order of its points: KITTI files and LIO-SAM's
/// clouds are stored laser by laser but do not say so (method.md 3.6). A new ring begins where the
/// azimuth starts its turn anew. The turn may run either way and begin at +x, +y, -x, -y or at the
/// scan's first point; of these the one is taken that makes the fewest rings, and of these the most
/// even in elevation. Sets Point::ring (0, 1, ... in the order of the file) and returns true only
/// if the result is plausible: 4 to 130 rings, of which neighbours differ in mean elevation in one
/// direction for at least nine in ten. Otherwise leaves the points alone and returns false.
bool recoverRings(std::vector<Point>& points);

}  // namespace segdf

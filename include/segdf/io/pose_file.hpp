// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// KITTI pose file: one 3x4 row-major matrix a line.
/// @throws IoError naming file and line when a line does not hold 12 finite numbers
std::vector<Pose> readPoses(const std::filesystem::path& file);

/// The line `Tr: ...` of a KITTI calib.txt. @throws IoError when it is missing
Pose readCalibration(const std::filesystem::path& file);

/// The 12 numbers as KITTI writes them, enough digits to read back exactly.
std::string formatPose(const Pose& pose);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>

#include "segdf/evaluation/drive_scores.hpp"
#include "segdf/io/map_file.hpp"
#include "segdf/report/report_page.hpp"

#include "evaluate_drive.hpp"

namespace segdf::apps {

/// Everything that the report shows of one drive. instances.csv is looked for beside the folder of
/// labels.
/// @param map the map that was scored, or none: then the drive's labels are shown
/// @throws IoError
ReportScene makeScene(const LabelledDrive& drive,
                      const std::optional<MapCloud>& map,
                      const DriveScores& scores);

/// Writes the draft's coloured map as DIR/DRIVE_map.pcd and DIR/DRIVE_map.png. @throws IoError
void writeDraftMap(const std::filesystem::path& folder, const DriveScores& scores);

}  // namespace segdf::apps

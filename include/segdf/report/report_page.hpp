// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "segdf/evaluation/drive_scores.hpp"
#include "segdf/report/evidence.hpp"
#include "segdf/report/view_cloud.hpp"

namespace segdf {

/// One drive of the report.
struct ReportScene {
  DriveScores scores;
  std::string map_png;  ///< the draft's coloured map, empty if it was not asked for
  PackedCloud cloud;
  std::vector<Eigen::Vector3d> trajectory;  ///< of the sensor, metres
  Evidence evidence;                        ///< empty when the run left no instances.csv
  /// Moving points of the truth, of all points, by the run's instance (those with an id in labels).
  std::map<std::uint16_t, Share> truth_of_instance;
};

/// The library that draws the interactive view.
struct ThreeJs {
  std::string library;
  std::string orbit_controls;
};

/// Reads three.js and its orbit controls, as Debian's libjs-three lays them out.
/// @throws IoError naming the folder and the package when they are not there
ThreeJs readThreeJs(const std::filesystem::path& folder);

/// Writes report.html into the folder, which is made: one page with everything in it that needs no
/// network. @throws IoError
void writeReport(const std::filesystem::path& folder,
                 const std::vector<ReportScene>& scenes,
                 const ThreeJs& three);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "segdf/mapping/instance_table.hpp"
#include "segdf/mapping/map_point.hpp"

namespace segdf {

/// The table that belongs to a map: "<stem>_instances.csv" beside it.
std::filesystem::path instanceFileOf(const std::filesystem::path& map);

/// @throws IoError if a map cannot be exported to this path: it is not absolute, does not end in
/// .pcd or .ply, or the map or its table exists already
void checkExport(const std::filesystem::path& map);

/// Writes points as binary PCD or PLY, by the extension, with the fields x y z intensity label
/// instance, and the table of instances beside it, the map last. Files appear whole or not at all,
/// and none that exists is touched. @throws IoError
void exportMap(const std::filesystem::path& map,
               const std::vector<MapPoint>& points,
               const std::vector<InstanceRecord>& instances);

}  // namespace segdf

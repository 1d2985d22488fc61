// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "segdf/mapping/instance_table.hpp"

namespace segdf {

/// Writes instances.csv: a line for each instance with class, frames, points, size, verdict, votes
/// and what decided. Appears whole or not at all. @throws IoError
void writeInstanceCsv(const std::filesystem::path& file,
                      const std::vector<InstanceRecord>& records);

}  // namespace segdf

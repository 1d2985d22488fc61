// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace segdf {

/// SemanticKITTI .label file: one uint32 for each point, class in the lower and instance in the
/// upper half.
/// @throws IoError when it cannot be read, or its size is no multiple of 4
std::vector<std::uint32_t> readLabels(const std::filesystem::path& file);

/// Writes beside and renames. @throws IoError when it cannot be written whole
void writeLabels(const std::filesystem::path& file, const std::vector<std::uint32_t>& labels);

}  // namespace segdf

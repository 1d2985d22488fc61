// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace segdf {

/// Colour image, 8 bits a channel, rows from the top.
struct RgbImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 bytes a pixel
};

/// Writes beside and renames. @throws IoError
void writePng(const std::filesystem::path& file, const RgbImage& image);

/// The bytes of the PNG file. @throws IoError
std::string encodePng(const RgbImage& image);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
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

/// Image of few colours, rows from the top: a third of the memory, and of the time to write it.
struct PaletteImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::array<std::uint8_t, 3>> palette;  ///< 256 colours at most
  std::vector<std::uint8_t> pixels;                  ///< a colour of the palette each
};

/// Writes beside and renames. @throws IoError
void writePng(const std::filesystem::path& file, const RgbImage& image);
void writePng(const std::filesystem::path& file, const PaletteImage& image);

/// The bytes of the PNG file. @throws IoError
std::string encodePng(const RgbImage& image);

}  // namespace segdf

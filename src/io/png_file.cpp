// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/png_file.hpp"

#include <png.h>

#include "segdf/io/atomic_file.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

std::string encodePng(const RgbImage& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t bytes = 0;
  std::string file;
  const auto write = [&](void* memory) {
    return png_image_write_to_memory(&png, memory, &bytes, 0, image.rgb.data(), 0, nullptr) != 0;
  };
  bool written = write(nullptr);  // asks for the size
  if (written) {
    file.resize(bytes);
    written = write(file.data());
  }
  if (!written) throw IoError(std::string("cannot make a PNG image: ") + png.message);
  file.resize(bytes);
  return file;
}

void writePng(const std::filesystem::path& file, const RgbImage& image) {
  AtomicFile out(file);
  out.write(encodePng(image));
  out.commit();
}

}  // namespace segdf

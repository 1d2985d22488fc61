// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/label_file.hpp"

#include <fstream>
#include <string>

#include "segdf/io/atomic_file.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

std::vector<std::uint32_t> readLabels(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw IoError("cannot read label file " + file.string() + "; check the path");
  const auto bytes = static_cast<std::size_t>(stream.tellg());
  if (bytes % sizeof(std::uint32_t) != 0) {
    throw IoError("label file " + file.string() + " has " + std::to_string(bytes) +
                  " bytes, no multiple of 4: it is truncated or no label file");
  }
  std::vector<std::uint32_t> labels(bytes / sizeof(std::uint32_t));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(labels.data()), static_cast<std::streamsize>(bytes));
  if (!stream) throw IoError("cannot read label file " + file.string() + " to its end");
  return labels;
}

void writeLabels(const std::filesystem::path& file, const std::vector<std::uint32_t>& labels) {
  AtomicFile out(file);
  out.write(labels.data(), labels.size() * sizeof(std::uint32_t));
  out.commit();
}

}  // namespace segdf

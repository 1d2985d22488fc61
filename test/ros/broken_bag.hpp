// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

namespace segdf::test {

/// Spoils the record of the last cloud; the index at the end of the bag stays.
inline void breakLastCloud(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  // The field's name with its length stands only in a cloud's own bytes.
  const std::size_t cloud = bytes.rfind(std::string("\x09\0\0\0intensity", 13));
  const std::size_t record = bytes.rfind("op=\x02", cloud);  // "message" in the record's header
  ASSERT_NE(record, std::string::npos);
  bytes[record + 3] = '\x7F';
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

}  // namespace segdf::test

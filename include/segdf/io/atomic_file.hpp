// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace segdf {

/// A file that appears whole or not at all: written beside its place and renamed by commit(). Every
/// write is checked, so that a full disk is told at once.
class AtomicFile {
 public:
  /// @throws IoError naming the file when it cannot be created
  explicit AtomicFile(std::filesystem::path target);
  /// Removes what was written unless it was committed.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends bytes. @throws IoError
  void write(const void* data, std::size_t bytes);
  void write(const std::string& text) { write(text.data(), text.size()); }
  /// Overwrites the first bytes of the file, also after a write that failed. @throws IoError
  void rewriteStart(const std::string& text);
  /// Where the bytes are until commit(), for libraries that write files themselves.
  const std::filesystem::path& temporaryPath() const { return temporary_; }
  /// Closes the file and renames it into place. @throws IoError
  void commit();

 private:
  void check(const char* doing);

  std::filesystem::path target_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// A file that is in memory as a whole. @throws IoError
void writeWhole(const std::filesystem::path& file, const std::string& bytes);

}  // namespace segdf

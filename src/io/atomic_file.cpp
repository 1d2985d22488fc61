// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(fs::path target)
    : target_(std::move(target)), temporary_(target_.string() + ".partial") {
  errno = 0;
  // Writes come in large blocks: without a buffer a full disk is told by the write that meets it.
  stream_.rdbuf()->pubsetbuf(nullptr, 0);
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  check("create");
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;  // nothing better can be done in a destructor
  fs::remove(temporary_, ignored);
}

void AtomicFile::check(const char* doing) {
  if (stream_) return;
  const std::string reason = errno != 0 ? std::strerror(errno) : "unknown reason";
  throw IoError("cannot " + std::string(doing) + " " + target_.string() + ": " + reason +
                "; free some space or choose another folder");
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  stream_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
  check("write");
}

void AtomicFile::rewriteStart(const std::string& text) {
  stream_.clear();  // the start can be written even where the end did not fit
  stream_.seekp(0);
  write(text);
}

void AtomicFile::commit() {
  stream_.close();
  check("close");
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (error) throw IoError("cannot rename " + temporary_.string() + ": " + error.message());
  committed_ = true;
}

void writeWhole(const std::filesystem::path& file, const std::string& bytes) {
  AtomicFile out(file);
  out.write(bytes);
  out.commit();
}

}  // namespace segdf

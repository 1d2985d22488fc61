// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/output_folder.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace fs = std::filesystem;

namespace {

/// `partial`, or `partial-2`, ... when an earlier run was cut off and left its results there.
fs::path freeStaging(const fs::path& folder) {
  fs::path staging = folder / "partial";
  for (int k = 2; fs::exists(staging); ++k) staging = folder / ("partial-" + std::to_string(k));
  return staging;
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

/// Kinds of files in a folder of results.
std::set<fs::path> extensionsIn(const fs::path& folder) {
  std::set<fs::path> extensions;
  for (const fs::path& entry : entriesOf(folder)) extensions.insert(entry.extension());
  return extensions;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& folder) : folder_(folder) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!error) {
    staging_ = freeStaging(folder_);
    fs::create_directory(staging_, error);
  }
  if (error) {
    throw IoError("cannot write to output folder " + folder_.string() + ": " + error.message() +
                  "; choose another with --output");
  }
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove(staging_, ignored);  // removes an empty folder only
}

void OutputFolder::replaceFolder(const fs::path& from, const fs::path& to) const {
  if (fs::is_directory(to)) {
    const std::set<fs::path> ours = extensionsIn(from);
    for (const fs::path& old : entriesOf(to)) {
      if (ours.count(old.extension()) == 0) {
        throw IoError(to.string() + " holds " + old.filename().string() +
                      ", which segdf did not write; the new results are in " + staging_.string());
      }
    }
    fs::remove_all(to);
  }
  fs::rename(from, to);
}

void OutputFolder::commit() {
  try {
    for (const fs::path& entry : entriesOf(staging_)) {
      const fs::path target = folder_ / entry.filename();
      if (fs::is_directory(entry)) {
        replaceFolder(entry, target);
      } else {
        fs::rename(entry, target);
      }
    }
  } catch (const fs::filesystem_error& error) {
    throw IoError("cannot move results into " + folder_.string() + ": " + error.code().message() +
                  "; they are in " + staging_.string());
  }
}

}  // namespace segdf

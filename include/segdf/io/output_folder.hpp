// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace segdf {

/// An output folder whose contents appear whole or not at all: everything is written into a staging
/// folder inside it and moved into place by commit(). Without a commit the staging folder stays, so
/// that nothing already computed is lost; an empty one is removed.
class OutputFolder {
 public:
  /// Makes the folder and tries whether it can be written.
  /// @throws IoError naming the folder, before any work is done
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write until commit().
  const std::filesystem::path& staging() const { return staging_; }
  const std::filesystem::path& path() const { return folder_; }

  /// Moves everything into place. Files of the same name are replaced; a folder takes
  /// the place of the old one unless that holds another kind of file than the new: then that file
  /// is left alone and stops the commit.
  /// @throws IoError naming what could not be moved and where the results are
  void commit();

 private:
  void replaceFolder(const std::filesystem::path& from, const std::filesystem::path& to) const;

  std::filesystem::path folder_;
  std::filesystem::path staging_;
};

}  // namespace segdf

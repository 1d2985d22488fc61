// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <sys/wait.h>

namespace segdf::test {

/// What a program did.
struct Outcome {
  int status = -1;  ///< exit status
  std::string out;  ///< standard output
  std::string err;  ///< standard error

  /// Lines of standard error that begin so.
  int errorLines(const std::string& start) const {
    int count = 0;
    for (std::size_t at = 0; at < err.size(); at = err.find('\n', at) + 1) {
      count += err.compare(at, start.size(), start) == 0 ? 1 : 0;
      if (err.find('\n', at) == std::string::npos) break;
    }
    return count;
  }
};

inline std::string readText(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a command line in the shell, with its output caught in `folder`.
inline Outcome run(const std::string& command, const std::filesystem::path& folder) {
  const std::filesystem::path out = folder / "stdout.txt";
  const std::filesystem::path err = folder / "stderr.txt";
  const int raw = std::system((command + " >" + out.string() + " 2>" + err.string()).c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, readText(out), readText(err)};
}

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace segdf {

/// Counts what goes wrong, by kind, and says when it is worth a line in the log: the 1st, 10th,
/// 100th, ... time. Not thread-safe.
class Tally {
 public:
  /// @return true if this time should be told
  bool count(const std::string& kind);

  std::size_t of(const std::string& kind) const;

 private:
  std::map<std::string, std::size_t> counts_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Input or output that cannot be used. what() is one line that names the thing, its value and what
/// to do.
class IoError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where a drive comes from: a KITTI folder or a bag. Holds one scan at a time.
class ScanSource {
 public:
  ScanSource() = default;
  virtual ~ScanSource() = default;
  ScanSource(const ScanSource&) = delete;
  ScanSource& operator=(const ScanSource&) = delete;

  /// The next scan in the order of the recording; nothing at the end.
  /// @throws IoError when the data breaks off here; scans already given stay valid.
  virtual std::optional<Scan> next() = 0;

  /// Number of scans that next() will give in all.
  virtual std::size_t size() const = 0;

  /// One line for the report, e.g. "KITTI folder drive/ (80 scans)".
  virtual std::string describe() const = 0;
};

}  // namespace segdf

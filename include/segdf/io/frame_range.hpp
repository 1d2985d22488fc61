// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>

namespace segdf {

/// Part of a drive: scans first, first + step, ... up to and including last, counted from 0 in the
/// order of the files, which is the number in the file names of KITTI's sequences.
struct FrameRange {
  std::size_t first = 0;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  std::size_t step = 1;

  /// True iff it takes every scan of any drive.
  bool isAll() const;
};

/// Reads "A:B" or "A:B:STEP", both ends inclusive. @throws IoError when it is neither
FrameRange parseFrameRange(const std::string& text);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/frame_range.hpp"

#include <regex>
#include <stdexcept>

#include "segdf/io/scan_source.hpp"

namespace segdf {

bool FrameRange::isAll() const {
  return first == 0 && step == 1 && last == std::numeric_limits<std::size_t>::max();
}

FrameRange parseFrameRange(const std::string& text) {
  // Nine digits at most: no number that overflows.
  static const std::regex form("([0-9]{1,9}):([0-9]{1,9})(?::([0-9]{1,9}))?");
  std::smatch match;
  FrameRange range;
  const bool well_formed = std::regex_match(text, match, form);
  if (well_formed) {
    range.first = std::stoul(match[1]);
    range.last = std::stoul(match[2]);
    if (match[3].matched) range.step = std::stoul(match[3]);
  }
  if (!well_formed || range.step == 0 || range.last < range.first) {
    throw IoError("frames '" + text +
                  "' are no range; give FIRST:LAST or FIRST:LAST:STEP, e.g. 4390:4530:2");
  }
  return range;
}

}  // namespace segdf

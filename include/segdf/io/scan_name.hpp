// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>

namespace segdf {

/// "000012" for scan 12: the stem of its files in KITTI's layout.
inline std::string scanName(std::size_t number) {
  std::ostringstream name;
  name << std::setw(6) << std::setfill('0') << number;
  return name.str();
}

}  // namespace segdf

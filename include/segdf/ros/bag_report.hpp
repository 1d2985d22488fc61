// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "segdf/ros/bag_source.hpp"

namespace segdf {

/// What a check of a bag found. Each text is one line.
struct BagReport {
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and text
  std::vector<std::string> warnings;  ///< the bag can be used, but gives less than it could
  std::vector<std::string> errors;    ///< it cannot be used
  BagTopics topics;                   ///< those that hold the drive; empty if there are none
};

/// A number with so many digits behind the point.
std::string fixed(double value, int digits);

}  // namespace segdf

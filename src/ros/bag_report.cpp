// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/bag_report.hpp"

#include <iomanip>
#include <sstream>

namespace segdf {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

}  // namespace segdf

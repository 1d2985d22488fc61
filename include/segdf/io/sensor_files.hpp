// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace segdf {

/// Text of cfg/sensors/NAME.yaml by NAME, built in when the package was configured.
const std::map<std::string, std::string>& sensorFiles();

}  // namespace segdf

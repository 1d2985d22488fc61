// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace segdf {

/// Texts of cfg/scenes/NAME.yaml by name, built in when segdf is compiled.
const std::map<std::string, std::string>& sceneFiles();

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace segdf {

/// Text of src/report/page/NAME by NAME, built in when the package was configured.
const std::map<std::string, std::string>& pageFiles();

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace segdf {

/// SemanticKITTI's name of a class, the same for moving and standing ones ("car" for 10 and 252);
/// "class N" for one that it does not know.
std::string className(std::uint16_t semantic_class);

}  // namespace segdf

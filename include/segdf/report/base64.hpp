// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace segdf {

/// Bytes as base64 (RFC 4648) with padding: how a page holds binary data.
std::string encodeBase64(const std::string& bytes);

}  // namespace segdf

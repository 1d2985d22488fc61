// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/dynamics/dynamic_filter.hpp"

#include <stdexcept>

#include "segdf/dynamics/literal_filter.hpp"
#include "segdf/dynamics/visibility_filter.hpp"

namespace segdf {

std::unique_ptr<DynamicFilter> makeDynamicFilter(const Config& config, IdSource& ids, int threads) {
  switch (config.df.mode) {
    case FilterMode::kLiteral:
      return std::make_unique<LiteralFilter>(config, ids, threads);
    case FilterMode::kSegdf:
      return std::make_unique<VisibilityFilter>(config, ids, threads);
  }
  throw std::invalid_argument("parameter df.mode names no dynamic filter");
}

}  // namespace segdf

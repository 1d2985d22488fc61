// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/parallel.hpp"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(Parallel, EveryItemIsVisitedOnce) {
  for (int threads : {1, 2, 3}) {
    std::vector<int> visits(1001, 0);
    parallelFor(visits.size(), threads, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(1001, 1)) << threads;
  }
}

TEST(Parallel, BlocksCoverTheRangeWithoutOverlap) {
  std::vector<int> visits(1001, 0);
  parallelBlocks(visits.size(), 64, 2, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++visits[i];
  });
  EXPECT_EQ(visits, std::vector<int>(1001, 1));
}

TEST(Parallel, NothingToDoIsFine) {
  parallelFor(0, 2, [](std::size_t) { FAIL(); });
  parallelBlocks(0, 16, 2, [](std::size_t, std::size_t) { FAIL(); });
}

TEST(Parallel, ExceptionsReachTheCaller) {
  const auto body = [](std::size_t i) {
    if (i == 37) throw std::runtime_error("37");
  };
  EXPECT_THROW(parallelFor(100, 2, body), std::runtime_error);
  EXPECT_THROW(parallelFor(100, 1, body), std::runtime_error);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/nodelets/ledger.hpp"

#include <gtest/gtest.h>

namespace segdf {
namespace {

TEST(Ledger, LineAccountsForEveryCloud) {
  Counts counts;
  counts.clouds = 35;
  counts.pairs = 33;
  counts.processed = 30;
  counts.dropped = 2;
  counts.unmatched = 1;
  counts.clouds_waiting = 1;
  EXPECT_EQ(toText(counts),
            "35 clouds received: 30 filtered, 1 waiting for the filter, 2 dropped, 0 unusable, 1 "
            "without pose, 1 waiting for a pose");
}

TEST(Ledger, LineTellsHowLongAScanWaitedAndTook) {
  Counts counts;
  for (const double seconds : {0.25, 0.05, 0.15}) counts.filtering.add(seconds);
  for (const double seconds : {0.0, 3.0, 0.0}) counts.waiting.add(seconds);
  const std::string line = toText(counts);
  const std::string times =
      "; a scan waited 1.000 s on average, 3.000 s at most, and took 0.150 s on average, 0.250 s "
      "at "
      "most";
  EXPECT_EQ(line.substr(line.find(';')), times);
}

}  // namespace
}  // namespace segdf

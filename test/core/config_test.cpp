// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/core/config.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace segdf {
namespace {

std::string complaint(const Config& config) {
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Config, DefaultsAreValid) { EXPECT_EQ(complaint(Config{}), ""); }

TEST(Config, NamesTheParameterItsValueAndItsBound) {
  Config config;
  config.ground.th_seed = 9.0;
  EXPECT_EQ(complaint(config), "parameter ground.th_seed = 9 is out of [0.01, 5] m");
}

TEST(Config, RefusesNaN) {
  Config config;
  config.cvi.drho = std::nan("");
  EXPECT_NE(complaint(config).find("cvi.drho = nan"), std::string::npos);
}

TEST(Config, ChecksEveryEntryOfAList) {
  Config config;
  config.ground.flatness[3] = 2.0;
  EXPECT_NE(complaint(config).find("ground.flatness = 2"), std::string::npos);
}

TEST(Config, RefusesARangeThatIsUpsideDown) {
  Config config;
  config.input.min_range = 10.0;
  config.input.max_range = 5.0;
  EXPECT_NE(complaint(config).find("input.min_range must be below"), std::string::npos);
}

TEST(FormatNumber, ReadsBackAsTheSameNumber) {
  EXPECT_EQ(formatNumber(0.2), "0.2");
  EXPECT_EQ(formatNumber(64.0), "64");
  EXPECT_EQ(formatNumber(0.000725), "0.000725");
  EXPECT_EQ(std::stod(formatNumber(1.0 / 3.0)), 1.0 / 3.0);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/ros/bag_check.hpp"

#include "ros/street_bag.hpp"
#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf::test {

/// A good bag for a test to spoil, and what the check says of it.
class BagCheck : public ::testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "drive.bag"; }

  BagReport check(const BagCheckOptions& options = {}) const {
    bag_.write(file());
    return checkBag(file(), options);
  }

  static std::string fact(const BagReport& report, const std::string& name) {
    for (const auto& [its_name, text] : report.facts) {
      if (its_name == name) return text;
    }
    return "";
  }

  static std::string all(const std::vector<std::string>& texts) {
    std::string joined;
    for (const std::string& text : texts) joined += text + "\n";
    return joined;
  }

  static void expectGood(const BagReport& report) {
    EXPECT_EQ(all(report.warnings), "");
    EXPECT_EQ(all(report.errors), "");
  }
  static void expectWarning(const BagReport& report, const std::string& part) {
    ASSERT_EQ(report.warnings.size(), 1U) << all(report.warnings);
    EXPECT_TRUE(contains(report.warnings.front(), part));
    EXPECT_EQ(all(report.errors), "");
  }
  static void expectError(const BagReport& report, const std::string& part) {
    ASSERT_EQ(report.errors.size(), 1U) << all(report.errors);
    EXPECT_TRUE(contains(report.errors.front(), part));
  }

  /// Moves clouds and poses, so that the drive begins 100 m from the origin.
  void startFarAway(bool registered) {
    std::vector<Scan> scans = StreetBag::scans();
    for (Scan& scan : scans) scan.pose.pretranslate(Eigen::Vector3d(100.0, 0.0, 0.0));
    bag_ = StreetBag(scans, registered);
  }

  TempFolder folder_;
  StreetBag bag_ = StreetBag::registered();
};

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "segdf/io/kitti_writer.hpp"

#include "support/box_world.hpp"
#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace segdf::test {

/// A short drive on disk, with a car that passes, and a folder for results.
class DriveFixture : public ::testing::Test {
 protected:
  static constexpr int kScans = 5;

  void SetUp() override {
    BoxWorld world = makeStreet();
    const std::size_t car = world.add(-20.0, -4.0, 4.2, 1.8, 1.5);
    KittiWriter writer(drive());
    for (int k = 0; k < kScans; ++k) {
      world.moveTo(car, -12.0 + 6.0 * k, -4.0);
      const Scan scan = world.scan(0.4 * k, 0.0, 0.0, 100000000L * k, 500);
      std::vector<std::uint32_t> truth;
      for (const Point& p : scan.points) {
        const Eigen::Vector3d x = scan.pose * p.position().cast<double>();
        const bool on_car = std::abs(x.y() + 4.0) < 1.0 && x.z() > 0.05 && x.z() < 1.6;
        truth.push_back(on_car ? (1U << 16U) | 252U : 50U);
      }
      writer.add(scan, truth, scan.pose);
    }
    writer.finish();
  }

  std::filesystem::path drive() const { return folder_ / "drive"; }
  std::filesystem::path bag() const { return folder_ / "drive.bag"; }
  std::filesystem::path result() const { return folder_ / "result"; }
  std::filesystem::path scanFile(const std::string& number) const {
    return drive() / "velodyne" / (number + ".bin");
  }

  Outcome offline(const std::string& arguments) const {
    return run(std::string(SEGDF_OFFLINE) + " --output " + result().string() + " " + arguments,
               folder_.path());
  }
  Outcome offlineOnDrive(const std::string& more = "") const {
    return offline("--kitti " + drive().string() + " " + more);
  }
  Outcome makeBag(const std::string& more = "") const {
    return run(std::string(SEGDF_KITTI_TO_BAG) + " --kitti " + drive().string() + " --output " +
                   bag().string() + " " + more,
               folder_.path());
  }
  std::string labels(int scan) const {
    return readText(result() / "labels" / ("00000" + std::to_string(scan) + ".label"));
  }

  /// The program failed with one line that says so.
  static void expectError(const Outcome& outcome, int status, const std::string& part) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.errorLines("error: "), 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
  }
  /// And left no results behind.
  void expectRefusal(const Outcome& outcome, int status, const std::string& part) const {
    expectError(outcome, status, part);
    EXPECT_FALSE(std::filesystem::exists(result() / "static_map.pcd"));
  }

  TempFolder folder_;
};

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include <gtest/gtest.h>

#include "segdf/io/kitti_source.hpp"
#include "segdf/io/kitti_writer.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/pose_file.hpp"

#include "support/box_world.hpp"
#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::errorOf;

class Kitti : public ::testing::Test {
 protected:
  void SetUp() override {
    KittiWriter writer(drive());
    for (int k = 0; k < 3; ++k) {
      Scan scan = test::makeStreet().scan(2.0 + 0.5 * k, -1.0, 5.0 * k, 100000000L * k, 200);
      const std::vector<std::uint32_t> truth(scan.points.size(), 40U + static_cast<unsigned>(k));
      scans_.push_back(scan);
      writer.add(scan, truth, scan.pose);
    }
    writer.finish();
  }

  fs::path drive() const { return folder_ / "drive"; }
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }
  static std::string read(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TempFolder folder_;
  std::vector<Scan> scans_;
};

TEST_F(Kitti, WhatIsWrittenReadsBack) {
  KittiSource source(drive());
  ASSERT_EQ(source.size(), 3U);
  EXPECT_FALSE(source.timesAssumed());
  const Pose first = scans_[0].pose;
  for (const Scan& written : scans_) {
    const auto scan = source.next();
    ASSERT_TRUE(scan);
    EXPECT_EQ(scan->stamp_ns, written.stamp_ns);
    EXPECT_TRUE(scan->pose.isApprox(first.inverse() * written.pose, 1e-9))
        << "frame of the first scan";
    ASSERT_EQ(scan->points.size(), written.points.size());
    for (std::size_t i = 0; i < scan->points.size(); ++i) {
      ASSERT_EQ(scan->points[i].position(), written.points[i].position());
      ASSERT_EQ(scan->points[i].intensity, written.points[i].intensity);
    }
  }
  EXPECT_FALSE(source.next());
  EXPECT_EQ(readLabels(drive() / "labels/000002.label"),
            std::vector<std::uint32_t>(scans_[2].points.size(), 42U));
}

TEST_F(Kitti, LidarPosesNeedNoCalibration) {
  fs::remove(drive() / "poses.txt");
  fs::remove(drive() / "calib.txt");
  std::string rows;
  for (const Scan& scan : scans_) rows += formatPose(scan.pose) + "\n";
  write(drive() / "poses_lidar.txt", rows);
  KittiSource source(drive());
  EXPECT_TRUE(source.next()->pose.isApprox(scans_[0].pose, 1e-12));
}

TEST_F(Kitti, SelectedFramesKeepTheFrameOfTheWholeDrive) {
  KittiSource source(drive(), 10.0, parseFrameRange("1:2"));
  ASSERT_EQ(source.size(), 2U);
  EXPECT_EQ(source.sizeOfDrive(), 3U);
  EXPECT_EQ(source.nameOf(0), "000001");
  const auto scan = source.next();
  EXPECT_EQ(scan->stamp_ns, scans_[1].stamp_ns);
  EXPECT_TRUE(scan->pose.isApprox(scans_[0].pose.inverse() * scans_[1].pose, 1e-9));
  ASSERT_TRUE(source.next());
  EXPECT_FALSE(source.next());
  KittiSource every_second(drive(), 10.0, parseFrameRange("0:2:2"));
  EXPECT_EQ(every_second.size(), 2U);
  EXPECT_EQ(every_second.positionOf(1), 2U);
}

TEST_F(Kitti, FramesThatAreNotThereAreNamed) {
  const auto open = [this](const std::string& frames) {
    return errorOf([&] { KittiSource(drive(), 10.0, parseFrameRange(frames)); });
  };
  EXPECT_TRUE(contains(open("1:3"), "frames up to 3"));
  for (const char* bad : {"", "1", "2:1", "0:2:0", "-1:2", "0:2:1:1", "a:b", "0:99999999999"}) {
    EXPECT_TRUE(contains(open(bad), "are no range")) << bad;
  }
}

TEST_F(Kitti, WithoutTimesTheRateIsAssumed) {
  fs::remove(drive() / "times.txt");
  KittiSource source(drive(), 2.0);
  EXPECT_TRUE(source.timesAssumed());
  source.next();
  EXPECT_EQ(source.next()->stamp_ns, 500000000);
}

TEST_F(Kitti, ATruncatedScanIsNamedAndTheScansBeforeItStay) {
  fs::resize_file(drive() / "velodyne/000001.bin", 1001);
  KittiSource source(drive());
  EXPECT_TRUE(source.next());
  const std::string message = errorOf([&] { source.next(); });
  EXPECT_TRUE(contains(message, "000001.bin has 1001 bytes, no multiple of 16"));
}

TEST_F(Kitti, FewerPosesThanScans) {
  const std::string poses = read(drive() / "poses.txt");
  write(drive() / "poses.txt", poses.substr(0, poses.find('\n') + 1));
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "1 poses for 3 scans"));
}

TEST_F(Kitti, FewerTimesThanScans) {
  write(drive() / "times.txt", "0\n0.1\n");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "2 times for 3 scans"));
}

TEST_F(Kitti, APoseThatIsNoneIsNamedWithItsLine) {
  write(drive() / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0\n");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "line 2 of"));
}

TEST_F(Kitti, MissingPartsAreNamed) {
  EXPECT_TRUE(
      contains(errorOf([] { KittiSource source("/nowhere"); }), "no folder /nowhere/velodyne"));
  fs::remove(drive() / "calib.txt");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "calib.txt"));
  write(drive() / "calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "no line 'Tr:"));
  fs::remove(drive() / "poses.txt");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "neither poses.txt nor"));
  fs::remove_all(drive() / "velodyne");
  fs::create_directory(drive() / "velodyne");
  EXPECT_TRUE(contains(errorOf([&] { KittiSource source(drive()); }), "no .bin file"));
}

TEST_F(Kitti, TheWriterNeverOverwritesADrive) {
  EXPECT_TRUE(contains(errorOf([&] { KittiWriter writer(drive()); }), "holds scans already"));
}

TEST_F(Kitti, TheWriterNamesAFolderThatCannotBe) {
  write(folder_ / "file", "x");
  EXPECT_TRUE(
      contains(errorOf([&] { KittiWriter writer(folder_ / "file" / "drive"); }), "cannot create"));
}

TEST_F(Kitti, ALabelFileOfOddSizeIsNamed) {
  write(folder_ / "odd.label", "12345");
  EXPECT_TRUE(contains(errorOf([&] { readLabels(folder_ / "odd.label"); }), "5 bytes"));
  EXPECT_TRUE(contains(errorOf([&] { readLabels(folder_ / "none.label"); }), "none.label"));
}

TEST_F(Kitti, AFullDiskLeavesNothingBehind) {
  // Every write to /dev/full fails as on a full disk.
  fs::create_symlink("/dev/full", folder_ / "x.label.partial");
  const std::vector<std::uint32_t> labels(100000, 1U);
  EXPECT_TRUE(
      contains(errorOf([&] { writeLabels(folder_ / "x.label", labels); }), "No space left"));
  EXPECT_FALSE(fs::exists(folder_ / "x.label"));
}

}  // namespace
}  // namespace segdf

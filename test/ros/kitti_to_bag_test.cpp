// SPDX-License-Identifier: BSD-3-Clause
// Runs the program segdf_kitti_to_bag.
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "segdf/io/kitti_writer.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/ros/bag_source.hpp"
#include "segdf/ros/topics.hpp"

#include "ros/sample_scan.hpp"
#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using test::contains;

constexpr int kScans = 3;
constexpr std::size_t kPoints = 20;

struct Ended {
  int status = -1;
  std::string output;  ///< standard output and error
};

Ended convert(const std::string& arguments) {
  const std::string command = std::string(SEGDF_KITTI_TO_BAG) + " " + arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {};
  Ended ended;
  std::array<char, 256> buffer{};
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) ended.output += buffer.data();
  const int status = pclose(pipe);
  if (WIFEXITED(status)) ended.status = WEXITSTATUS(status);
  return ended;
}

class KittiToBag : public ::testing::Test {
 protected:
  void SetUp() override {
    KittiWriter writer(folder_ / "drive");
    for (int k = 0; k < kScans; ++k) {
      const Scan scan = scanOf(k);
      writer.add(scan, std::vector<std::uint32_t>(kPoints, 252), scan.pose);
    }
    writer.finish();
  }

  static Scan scanOf(int k) {
    return test::sampleScan(kPoints, 5'000'000'000 + k * 100'000'000, static_cast<unsigned>(k));
  }
  std::string bag() const { return (folder_ / "drive.bag").string(); }
  std::string drive() const { return (folder_ / "drive").string(); }
  std::string paths() const { return "--kitti " + drive() + " --output " + bag(); }

  test::TempFolder folder_;
};

TEST_F(KittiToBag, WritesTheDriveWithItsLabels) {
  const Ended ended = convert(paths() + " --form sensor");
  ASSERT_EQ(ended.status, 0) << ended.output;
  EXPECT_TRUE(contains(ended.output, "3 scans, 3 of them with labels"));
  BagSource source(bag());
  ASSERT_EQ(source.size(), static_cast<std::size_t>(kScans));
  EXPECT_EQ(source.topics().cloud, topics::kDeskewedCloud);
  for (int k = 0; k < kScans; ++k) {
    const Scan read = *source.next();
    EXPECT_EQ(read.stamp_ns, scanOf(k).stamp_ns);
    EXPECT_EQ(read.points.at(7).position(), scanOf(k).points.at(7).position());
  }
  const rosbag::Bag file(bag());
  EXPECT_EQ(rosbag::View(file, rosbag::TopicQuery(topics::kTruthLabels)).size(), 3U);
}

TEST_F(KittiToBag, RegisteredIsTheDefaultForm) {
  ASSERT_EQ(convert(paths()).status, 0);
  EXPECT_EQ(BagSource(bag()).topics().cloud, topics::kRegisteredCloud);
}

TEST_F(KittiToBag, LabelsAreOptional) {
  std::filesystem::remove_all(folder_ / "drive/labels");
  const Ended ended = convert(paths());
  EXPECT_EQ(ended.status, 0) << ended.output;
  EXPECT_TRUE(contains(ended.output, "3 scans, 0 of them with labels"));
}

TEST_F(KittiToBag, ExistingBagNeedsForce) {
  ASSERT_EQ(convert(paths()).status, 0);
  const Ended again = convert(paths());
  EXPECT_EQ(again.status, 1);
  EXPECT_TRUE(contains(again.output, "drive.bag' exists: name another one, or give --force"));
  EXPECT_EQ(convert(paths() + " --force").status, 0);
}

TEST_F(KittiToBag, LabelsOfAnotherScanAreRefusedAndLeaveNoBag) {
  writeLabels(folder_ / "drive/labels/000001.label", {1, 2, 3});
  const Ended ended = convert(paths());
  EXPECT_EQ(ended.status, 1);
  EXPECT_TRUE(contains(ended.output, "000001.label has 3 labels for a scan of 20 points"));
  EXPECT_FALSE(std::filesystem::exists(bag()));
}

TEST_F(KittiToBag, WrongCommandLineIsAUsageError) {
  EXPECT_EQ(convert("--kitti " + drive()).status, 2);
  EXPECT_EQ(convert(paths() + " --form upside_down").status, 2);
  EXPECT_EQ(convert(paths() + " --rate 0").status, 2);
}

}  // namespace
}  // namespace segdf

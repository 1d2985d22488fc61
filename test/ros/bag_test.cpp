// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "segdf/ros/bag_source.hpp"
#include "segdf/ros/bag_writer.hpp"
#include "segdf/ros/lio_sam_messages.hpp"
#include "segdf/ros/topics.hpp"

#include "ros/broken_bag.hpp"
#include "ros/sample_scan.hpp"
#include "support/expect_error.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::errorOf;

constexpr std::int64_t kSecond = 1'000'000'000;

/// Scan k of a drive at 10 Hz from second 1000 on.
Scan scanOf(int k, std::size_t points = 50) {
  return test::sampleScan(points, 1000 * kSecond + k * kSecond / 10, static_cast<unsigned>(k));
}

void writeDrive(const fs::path& file, CloudForm form, int scans, std::size_t points = 50) {
  BagWriter writer(file, form);
  for (int k = 0; k < scans; ++k)
    writer.add(scanOf(k, points), std::vector<std::uint32_t>(points, 9));
  writer.finish();
}

std::string openRefusal(const fs::path& file, const BagTopics& topics = {}) {
  return errorOf([&] { BagSource source(file, topics); });
}

class BagRoundTrip : public ::testing::TestWithParam<CloudForm> {};

TEST_P(BagRoundTrip, GivesTheDriveBack) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", GetParam(), 4);
  BagSource source(folder / "drive.bag");
  EXPECT_EQ(source.size(), 4U);
  EXPECT_EQ(source.unmatched(), 0U);
  for (int k = 0; k < 4; ++k) {
    const std::optional<Scan> read = source.next();
    const Scan expected = scanOf(k);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->stamp_ns, expected.stamp_ns);
    EXPECT_TRUE(read->pose.isApprox(expected.pose, 1e-12));
    ASSERT_EQ(read->points.size(), expected.points.size());
    for (std::size_t i = 0; i < expected.points.size(); ++i) {
      EXPECT_LT((read->points[i].position() - expected.points[i].position()).norm(), 1e-3F);
    }
  }
  EXPECT_FALSE(source.next());
  EXPECT_FALSE(source.next()) << "and stays at the end";
}

INSTANTIATE_TEST_SUITE_P(Forms,
                         BagRoundTrip,
                         ::testing::Values(CloudForm::kRegistered, CloudForm::kSensor));

TEST(BagWriter, TruthGoesOnItsOwnTopic) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kRegistered, 2);
  const rosbag::Bag bag((folder / "drive.bag").string());
  rosbag::View truth(bag, rosbag::TopicQuery(topics::kTruthLabels));
  EXPECT_EQ(truth.size(), 2U);
  rosbag::View clouds(bag, rosbag::TopicQuery(topics::kRegisteredCloud));
  EXPECT_EQ(clouds.begin()->instantiate<sensor_msgs::PointCloud2>()->fields.size(), 4U);
}

TEST(BagWriter, DriveFromStampZeroIsMovedAsAWhole) {
  const test::TempFolder folder;
  BagWriter writer(folder / "drive.bag", CloudForm::kSensor);
  writer.add(test::sampleScan(5, 0));
  writer.add(test::sampleScan(5, kSecond / 10));
  writer.finish();
  BagSource source(folder / "drive.bag");
  EXPECT_EQ(source.next()->stamp_ns, BagWriter::kEpochNs);
  EXPECT_EQ(source.next()->stamp_ns, BagWriter::kEpochNs + kSecond / 10);
}

TEST(BagWriter, StampThatIsNoRosTimeIsRefused) {
  const test::TempFolder folder;
  BagWriter writer(folder / "drive.bag", CloudForm::kSensor);
  EXPECT_TRUE(contains(errorOf([&] { writer.add(test::sampleScan(5, -5)); }), "stamp of -5 ns"));
}

TEST(BagWriter, LabelsThatDoNotFitThePointsAreRefused) {
  const test::TempFolder folder;
  BagWriter writer(folder / "drive.bag", CloudForm::kSensor);
  EXPECT_TRUE(contains(errorOf([&] {
                         writer.add(scanOf(0), {1, 2, 3});
                       }),
                       "50 points has 3 labels"));
}

TEST(BagWriter, ExistingBagStaysUnlessOverwritten) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kSensor, 1);
  EXPECT_TRUE(
      contains(errorOf([&] { BagWriter(folder / "drive.bag", CloudForm::kSensor); }), "--force"));
  BagWriter writer(folder / "drive.bag", CloudForm::kSensor, true);
  writer.add(scanOf(0));
  writer.add(scanOf(1));
  EXPECT_EQ(BagSource(folder / "drive.bag").size(), 1U) << "the old bag until finish()";
  writer.finish();
  EXPECT_EQ(BagSource(folder / "drive.bag").size(), 2U);
}

TEST(BagWriter, UnfinishedBagLeavesNothing) {
  const test::TempFolder folder;
  {
    BagWriter writer(folder / "drive.bag", CloudForm::kSensor);
    writer.add(scanOf(0));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(BagWriter, FolderThatIsNotThereIsNamed) {
  const test::TempFolder folder;
  const std::string message =
      errorOf([&] { BagWriter(folder / "missing/drive.bag", CloudForm::kSensor); });
  EXPECT_TRUE(contains(message, "missing/drive.bag: No such file or directory"));
}

/// As long as it lives, no file of this process can grow beyond the limit, as if the disk were
/// full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::signal(SIGXFSZ, SIG_IGN);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST(BagWriter, FullDiskIsToldAndLeavesNothing) {
  const test::TempFolder folder;
  {
    const FileSizeLimit limit(1'000'000);
    BagWriter writer(folder / "drive.bag", CloudForm::kSensor);
    const std::string message = errorOf([&] {
      for (int k = 0; k < 4; ++k) writer.add(scanOf(k, 60'000));  // 1.3 MB each
      writer.finish();
    });
    EXPECT_TRUE(contains(message, "check the free space"));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(BagSource, MisspeltTopicListsTheTopicsOfTheBag) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kSensor, 1);
  const std::string message = openRefusal(folder / "drive.bag", {"/points_raw", ""});
  EXPECT_TRUE(contains(message, "has no topic '/points_raw'"));
  EXPECT_TRUE(contains(message, "/lio_sam/deskew/cloud_deskewed (sensor_msgs/PointCloud2)"));
  EXPECT_TRUE(contains(message, "/lio_sam/mapping/odometry (nav_msgs/Odometry)"));
}

TEST(BagSource, SlashBeforeTheTopicDoesNotMatter) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kSensor, 2);
  const BagTopics topics{"lio_sam/deskew/cloud_deskewed", "lio_sam/mapping/odometry"};
  EXPECT_EQ(BagSource(folder / "drive.bag", topics).size(), 2U);
}

TEST(BagSource, TopicOfAnotherTypeSaysSo) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kSensor, 1);
  EXPECT_TRUE(
      contains(openRefusal(folder / "drive.bag", {topics::kOdometry, ""}),
               "is nav_msgs/Odometry, but the cloud topic must be sensor_msgs/PointCloud2"));
}

TEST(BagSource, FeatureCloudIsRefusedWithTheRightOnes) {
  const test::TempFolder folder;
  writeDrive(folder / "drive.bag", CloudForm::kSensor, 1);
  const std::string message =
      openRefusal(folder / "drive.bag", {"lio_sam/mapping/cloud_registered", ""});
  EXPECT_TRUE(contains(message, "features"));
  EXPECT_TRUE(contains(message, topics::kRegisteredCloud));
  EXPECT_TRUE(contains(message, topics::kDeskewedCloud));
}

/// Writes messages at receipt times that have nothing to do with their stamps.
class BagWithOddities : public ::testing::Test {
 protected:
  void cloud(double received, int k) {
    bag_.write("/cloud", ros::Time(received), toSensorCloud(scanOf(k)));
  }
  void odometry(double received, int k) {
    bag_.write("/pose", ros::Time(received), toOdometry(scanOf(k)));
  }
  BagSource close() {
    bag_.close();
    return BagSource(folder_ / "odd.bag", {"/cloud", "/pose"});
  }

  test::TempFolder folder_;
  rosbag::Bag bag_{(folder_ / "odd.bag").string(), rosbag::bagmode::Write};
};

TEST_F(BagWithOddities, JoinsOnStampsWhicheverComesFirst) {
  cloud(5.0, 0);
  odometry(9.0, 0);
  odometry(4.0, 1);
  cloud(7.0, 1);
  BagSource source = close();
  EXPECT_EQ(source.size(), 2U);
  EXPECT_EQ(source.next()->stamp_ns, scanOf(0).stamp_ns);
  EXPECT_EQ(source.next()->stamp_ns, scanOf(1).stamp_ns);
}

TEST_F(BagWithOddities, CloudsWithoutPoseAreCountedAndLeftOut) {
  for (int k = 0; k < 5; ++k) cloud(10.0 + k, k);
  odometry(10.0, 1);
  odometry(11.0, 4);
  odometry(12.0, 17);  // a pose without cloud is nobody's loss
  BagSource source = close();
  EXPECT_EQ(source.size(), 2U);
  EXPECT_EQ(source.unmatched(), 3U);
  EXPECT_EQ(source.next()->stamp_ns, scanOf(1).stamp_ns);
  EXPECT_EQ(source.next()->stamp_ns, scanOf(4).stamp_ns) << "no dropped tail";
  EXPECT_FALSE(source.next());
}

TEST_F(BagWithOddities, ChangeOfTheOdometryFrameIsRefused) {
  odometry(1.0, 0);
  nav_msgs::Odometry other = toOdometry(scanOf(1));
  other.header.frame_id = "map";
  bag_.write("/pose", ros::Time(2.0), other);
  cloud(1.0, 0);
  EXPECT_TRUE(contains(errorOf([&] { close(); }), "changes its frame from 'odom' to 'map'"));
}

TEST(BagSource, MissingBagIsNamed) {
  EXPECT_TRUE(
      contains(openRefusal("/nowhere/drive.bag"), "bag '/nowhere/drive.bag' does not exist"));
}

TEST(BagSource, FileThatIsNoBagIsRefused) {
  const test::TempFolder folder;
  std::ofstream(folder / "text.bag") << "not a bag\n";
  EXPECT_TRUE(contains(openRefusal(folder / "text.bag"), "cannot read bag"));
}

TEST(BagSource, TruncatedBagAsksForReindex) {
  const test::TempFolder folder;
  const fs::path file = folder / "drive.bag";
  writeDrive(file, CloudForm::kSensor, 3);
  fs::resize_file(file, fs::file_size(file) * 2 / 3);
  const std::string message = openRefusal(file);
  EXPECT_TRUE(contains(message, "rosbag reindex " + file.string()));
}

TEST(BagSource, BagThatBreaksOffGivesWhatIsReadableAndThenSaysSo) {
  const test::TempFolder folder;
  const fs::path file = folder / "drive.bag";
  writeDrive(file, CloudForm::kSensor, 4);
  test::breakLastCloud(file);
  BagSource source(file);
  EXPECT_EQ(source.size(), 3U);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(source.next()->stamp_ns, scanOf(k).stamp_ns);
  EXPECT_TRUE(contains(errorOf([&] { source.next(); }), "cannot read bag '" + file.string() + "'"));
}

}  // namespace
}  // namespace segdf

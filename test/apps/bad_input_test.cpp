// SPDX-License-Identifier: BSD-3-Clause
// Every kind of bad input gets one clear line, the right exit status, and costs nothing already
// computed.
#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "segdf/io/pcd_stream.hpp"
#include "segdf/io/pose_file.hpp"
#include "segdf/ros/bag_writer.hpp"

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class BadInput : public test::DriveFixture {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(drive() / name) << text;
  }
  std::string config(const std::string& yaml) const {
    std::ofstream(folder_ / "my.yaml") << yaml;
    return "--config " + (folder_ / "my.yaml").string();
  }
  /// The run went on to its end, and said this in a warning.
  void expectWarning(const Outcome& outcome, int status, const std::string& part) const {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.errorLines("warning: "), 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
    EXPECT_TRUE(fs::exists(result() / "static_map.pcd"));
  }
};

TEST_F(BadInput, MissingFolder) {
  expectRefusal(offline("--kitti /nowhere"), 1, "no folder /nowhere/velodyne");
}

TEST_F(BadInput, MissingBag) { expectRefusal(offline("--bag /nowhere.bag"), 1, "/nowhere.bag"); }

TEST_F(BadInput, NeitherFolderNorBag) {
  expectRefusal(offline(""), 2, "--bag FILE or --kitti DIR");
}

TEST_F(BadInput, UnknownOption) { expectRefusal(offlineOnDrive("--thread 2"), 2, "--thread"); }

TEST_F(BadInput, UnknownParameter) {
  expectRefusal(offlineOnDrive(config("ground: {th_sed: 1}")), 1,
                "unknown parameter 'ground.th_sed'");
}

TEST_F(BadInput, ParameterOutOfBounds) {
  expectRefusal(offlineOnDrive(config("cvi: {dphi: 99}")), 1,
                "cvi.dphi = 99 is out of [0.05, 30] deg");
}

TEST_F(BadInput, UnknownSensor) {
  expectRefusal(offlineOnDrive("--sensor hdl65"), 1,
                "unknown sensor 'hdl65'; known are: hdl32, hdl64");
}

TEST_F(BadInput, UnknownMode) {
  expectRefusal(offlineOnDrive("--mode quick"), 1, "df.mode = quick");
}

TEST_F(BadInput, UnwritableOutputFolder) {
  std::ofstream(folder_ / "file") << "x";
  const Outcome outcome = test::run(std::string(SEGDF_OFFLINE) + " --kitti " + drive().string() +
                                        " --output " + (folder_ / "file/out").string(),
                                    folder_.path());
  expectRefusal(outcome, 1, "cannot write to output folder");
}

TEST_F(BadInput, UnwritableFolderForSegments) {
  std::ofstream(folder_ / "file") << "x";
  expectRefusal(offlineOnDrive("--dump-segments " + (folder_ / "file/out").string()), 1,
                "cannot write to output folder " + (folder_ / "file/out").string());
}

TEST_F(BadInput, FewerPosesThanScans) {
  write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  expectRefusal(offlineOnDrive(), 1, "1 poses for 5 scans");
}

TEST_F(BadInput, TheFirstScanIsBroken) {
  fs::resize_file(scanFile("000000"), 1000);
  expectRefusal(offlineOnDrive(), 1, "no multiple of 16");
}

TEST_F(BadInput, ALaterScanIsBrokenAndTheEarlierOnesAreSaved) {
  fs::resize_file(scanFile("000003"), 1000);
  const Outcome outcome = offlineOnDrive();
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_EQ(outcome.errorLines("error: "), 1);
  EXPECT_TRUE(contains(outcome.err, "000003.bin has 1000 bytes, no multiple of 16"));
  EXPECT_TRUE(contains(outcome.err, "the 3 scans before it are saved"));
  EXPECT_TRUE(fs::exists(result() / "static_map.pcd"));
  EXPECT_TRUE(fs::exists(result() / "labels/000002.label"));
  EXPECT_FALSE(fs::exists(result() / "labels/000003.label"));
}

TEST_F(BadInput, AnEmptyScanIsLeftOut) {
  fs::resize_file(scanFile("000002"), 0);
  expectWarning(offlineOnDrive(), 0, "1 scans left out: no usable point (the first is scan 2)");
  EXPECT_EQ(labels(2), "");
  EXPECT_NE(labels(4), "");
}

TEST_F(BadInput, NaNPointsAreCounted) {
  std::fstream file(scanFile("000001"), std::ios::in | std::ios::out | std::ios::binary);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int k = 0; k < 7; ++k) {
    file.seekp(160 * k);
    file.write(reinterpret_cast<const char*>(&nan), sizeof(nan));
  }
  file.close();
  expectWarning(offlineOnDrive(), 0, "7 points with NaN or infinite coordinates");
}

TEST_F(BadInput, TimeRunningBackwards) {
  write("times.txt", "0\n0.1\n0.05\n0.3\n0.4\n");
  expectWarning(offlineOnDrive(), 3, "1 scans left out: time runs backwards (the first is scan 2)");
}

TEST_F(BadInput, APoseThatIsNoRotation) {
  std::string poses;
  for (int k = 0; k < kScans; ++k) {
    poses += k == 1 ? "0 0 0 0 0 0 0 0 0 0 0 0\n" : formatPose(Pose::Identity()) + "\n";
  }
  write("poses.txt", poses);
  const Outcome outcome = offlineOnDrive();
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.err, "1 scans left out: invalid pose (the first is scan 1)"));
}

TEST_F(BadInput, PosesThatDoNotFitTheScans) {
  std::string poses;
  for (int k = 0; k < kScans; ++k) {
    Pose pose = Pose::Identity();
    pose.translation() =
        Eigen::Vector3d(0.4 * k, 0.0, k % 2 == 0 ? 0.0 : 0.25);  // camera x is sideways
    // Far enough not to fit, not so far that it is taken for a loop closure.
    pose.translation().x() += k % 2 == 0 ? 0.0 : 0.35;
    poses += formatPose(pose) + "\n";
  }
  write("poses.txt", poses);
  const Outcome outcome = offlineOnDrive();
  expectWarning(outcome, 0, "poses do not fit the scans: consecutive scans disagree by ");
  EXPECT_TRUE(contains(outcome.err, "input.max_misfit = 0.100 m"));
}

TEST_F(BadInput, MisspeltTopicListsThoseOfTheBag) {
  ASSERT_EQ(makeBag().status, 0);
  const Outcome outcome = offline("--bag " + bag().string() + " --cloud-topic /clouds");
  expectRefusal(outcome, 1, "/clouds");
  EXPECT_TRUE(contains(outcome.err, "/lio_sam/mapping/cloud_registered_raw"));
  EXPECT_TRUE(contains(outcome.err, "/lio_sam/mapping/odometry"));
}

TEST_F(BadInput, TruncatedBag) {
  ASSERT_EQ(makeBag().status, 0);
  fs::resize_file(bag(), fs::file_size(bag()) / 2);
  expectRefusal(offline("--bag " + bag().string()), 1, "drive.bag");
}

TEST_F(BadInput, CloudWithoutIntensity) {
  {
    rosbag::Bag out(bag().string(), rosbag::bagmode::Write);
    sensor_msgs::PointCloud2 cloud;
    cloud.header.stamp = ros::Time(10.0);
    cloud.header.frame_id = "odom";
    sensor_msgs::PointCloud2Modifier modifier(cloud);
    modifier.setPointCloud2FieldsByString(1, "xyz");
    modifier.resize(10);
    nav_msgs::Odometry odometry;
    odometry.header = cloud.header;
    odometry.pose.pose.orientation.w = 1.0;
    out.write("/lio_sam/mapping/odometry", ros::Time(10.0), odometry);
    out.write("/lio_sam/mapping/cloud_registered_raw", ros::Time(10.0), cloud);
  }
  const Outcome outcome = offline("--bag " + bag().string());
  expectRefusal(outcome, 1, "intensity");
  EXPECT_TRUE(contains(outcome.err, "x y z"));
}

TEST_F(BadInput, FullDiskKeepsWhatWasWritten) {
  // Files may grow to 1600 blocks of 512 bytes: enough for labels and the map of the first scan,
  // not for more.
  const std::string script = "(ulimit -f 1600; trap '' XFSZ; " + std::string(SEGDF_OFFLINE) +
                             " --kitti " + drive().string() + " --output " + result().string() +
                             ")";
  const Outcome outcome = test::run(script, folder_.path());
  expectRefusal(outcome, 1, "cannot write");
  EXPECT_TRUE(contains(outcome.err, "static_map.pcd"));
  EXPECT_TRUE(contains(outcome.err, "what was computed is in"));
  EXPECT_TRUE(fs::exists(result() / "partial/labels/000000.label"));
  std::size_t points = 0;
  forEachPoint(result() / "partial/static_map.pcd", [&points](const MapPoint&) { ++points; });
  EXPECT_GT(points, 1000U) << "the map of the scans that fitted can be read";
}

}  // namespace
}  // namespace segdf

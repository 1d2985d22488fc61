// SPDX-License-Identifier: BSD-3-Clause
// segdf_offline on good input: what it writes, and that it is always the same.
#include <algorithm>
#include <fstream>
#include <map>
#include <set>

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/label_file.hpp"

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class Offline : public test::DriveFixture {
 protected:
  std::vector<std::string> allLabels() const {
    std::vector<std::string> all;
    for (int k = 0; k < kScans; ++k) all.push_back(labels(k));
    return all;
  }
};

TEST_F(Offline, WritesEverythingThatItsUsersAreTold) {
  const Outcome outcome = offlineOnDrive();
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "recognised sensor hdl64"));
  EXPECT_TRUE(contains(outcome.out, "5 of 5 scans mapped"));
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(result())) names.insert(entry.path().filename());
  EXPECT_EQ(names, (std::set<std::string>{"config.yaml", "dynamic_points.pcd", "evidence.csv",
                                          "instances.csv", "labels", "map.png", "report.json",
                                          "static_map.pcd"}));
  EXPECT_EQ(test::readText(result() / "map.png").substr(1, 3), "PNG");
  EXPECT_TRUE(
      contains(test::readText(result() / "instances.csv"), "id,parent,class,frames,points"));
  EXPECT_TRUE(contains(test::readText(result() / "report.json"), "\"peak_memory_mib\""));
  EXPECT_TRUE(contains(test::readText(result() / "config.yaml"), "th_seed: 0.3"));
}

TEST_F(Offline, EveryPointIsInOneMapAndPclReadsThem) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  pcl::PCLPointCloud2 kept;
  pcl::PCLPointCloud2 removed;
  ASSERT_EQ(pcl::io::loadPCDFile((result() / "static_map.pcd").string(), kept), 0);
  ASSERT_EQ(pcl::io::loadPCDFile((result() / "dynamic_points.pcd").string(), removed), 0);
  std::vector<std::string> fields;
  for (const auto& field : kept.fields) fields.push_back(field.name);
  EXPECT_EQ(fields, (std::vector<std::string>{"x", "y", "z", "intensity", "label", "instance"}));
  std::size_t labelled_kept = 0;
  std::size_t labelled_removed = 0;
  for (int k = 0; k < kScans; ++k) {
    for (std::uint32_t label :
         readLabels(result() / "labels" / ("00000" + std::to_string(k) + ".label"))) {
      const std::uint16_t c = semantic_kitti::classOf(label);
      labelled_removed += c == semantic_kitti::kDynamic ? 1 : 0;
      labelled_kept += c != semantic_kitti::kDynamic && c != semantic_kitti::kUnlabelled ? 1 : 0;
    }
  }
  EXPECT_EQ(kept.width, labelled_kept);
  EXPECT_EQ(removed.width, labelled_removed);
  EXPECT_GT(removed.width, 0U);
}

TEST_F(Offline, SameBytesAgainAndOnTwoThreads) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const auto labels = allLabels();
  const std::string map = test::readText(result() / "static_map.pcd");
  const std::string instances = test::readText(result() / "instances.csv");
  for (const char* threads : {"--threads 1", "--threads 2"}) {
    ASSERT_EQ(offlineOnDrive(threads).status, 0);
    EXPECT_EQ(allLabels(), labels);
    EXPECT_EQ(test::readText(result() / "static_map.pcd"), map);
    EXPECT_EQ(test::readText(result() / "instances.csv"), instances);
  }
}

TEST_F(Offline, BothFormsOfBagAreFilteredAsTheFolderIs) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const auto folder_labels = allLabels();
  for (const char* form : {"registered", "sensor"}) {
    ASSERT_EQ(makeBag(std::string("--force --form ") + form).status, 0);
    const Outcome outcome = offline("--bag " + bag().string());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    // Poses go through quaternions and points through the odometry frame: a point on the border of
    // a cell may fall on its other side. Ids and verdicts of all but a few points agree.
    std::size_t differ = 0;
    std::size_t all = 0;
    for (int k = 0; k < kScans; ++k) {
      const std::string now = labels(k);
      ASSERT_EQ(now.size(), folder_labels[static_cast<std::size_t>(k)].size());
      for (std::size_t i = 0; i < now.size(); i += 4) {
        differ += now.compare(i, 4, folder_labels[static_cast<std::size_t>(k)], i, 4) != 0 ? 1 : 0;
        ++all;
      }
    }
    EXPECT_LT(static_cast<double>(differ), 0.01 * static_cast<double>(all)) << form;
  }
}

TEST_F(Offline, AVoxelThinsTheMap) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const auto whole = fs::file_size(result() / "static_map.pcd");
  std::ofstream(folder_ / "my.yaml") << "map: {voxel: 0.5}\n";
  ASSERT_EQ(offlineOnDrive("--config " + (folder_ / "my.yaml").string()).status, 0);
  EXPECT_LT(fs::file_size(result() / "static_map.pcd"), whole / 2);
  EXPECT_TRUE(contains(test::readText(result() / "config.yaml"), "voxel: 0.5"));
}

TEST_F(Offline, ASecondRunReplacesTheLabelsOfALongerDrive) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  std::ofstream(result() / "labels/000099.label") << "old";
  ASSERT_EQ(offlineOnDrive().status, 0);
  EXPECT_FALSE(fs::exists(result() / "labels/000099.label"));
}

TEST_F(Offline, AFileThatIsNotOursIsNeverDeleted) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  std::ofstream(result() / "labels/notes.txt") << "mine";
  const Outcome outcome = offlineOnDrive();
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(contains(outcome.err, "notes.txt"));
  EXPECT_TRUE(fs::exists(result() / "labels/notes.txt"));
}

TEST_F(Offline, DumpsSegmentsInColoursThatPclReads) {
  const fs::path dump = folder_ / "segments";
  ASSERT_EQ(offlineOnDrive("--dump-segments " + dump.string()).status, 0);
  for (int k = 0; k < kScans; ++k) {
    const auto codes = readLabels(result() / "labels" / ("00000" + std::to_string(k) + ".label"));
    const auto judged = static_cast<std::size_t>(
        std::count_if(codes.begin(), codes.end(), [](std::uint32_t c) { return c != 0; }));
    for (const char* kind : {"instances", "classes"}) {
      const fs::path stem = dump / kind / ("00000" + std::to_string(k));
      pcl::PointCloud<pcl::PointXYZRGB> cloud;
      ASSERT_EQ(pcl::io::loadPCDFile(stem.string() + ".pcd", cloud), 0);
      EXPECT_EQ(cloud.size(), judged);
      EXPECT_EQ(test::readText(stem.string() + ".png").substr(1, 3), "PNG");
    }
  }
}

TEST_F(Offline, EveryInstanceAndEveryClassHasOneColour) {
  const fs::path dump = folder_ / "segments";
  ASSERT_EQ(offlineOnDrive("--dump-segments " + dump.string()).status, 0);
  const auto coloursOf = [&](const std::string& kind) {
    pcl::PCLPointCloud2 blob;
    pcl::PointCloud<pcl::PointXYZRGB> cloud;
    const std::string file = (dump / kind / "000002.pcd").string();
    EXPECT_EQ(pcl::io::loadPCDFile(file, blob), 0);
    EXPECT_EQ(pcl::io::loadPCDFile(file, cloud), 0);
    std::map<std::uint32_t, std::set<std::uint32_t>> colours;
    for (pcl::uindex_t i = 0; i < cloud.size(); ++i) {
      const auto instance = blob.at<std::uint32_t>(i, 20);  // after x y z intensity label
      if (instance != 0) colours[instance].insert(cloud[i].rgba & 0xFFFFFFU);
    }
    return colours;
  };
  std::set<std::uint32_t> of_instances;
  for (const auto& [instance, colours] : coloursOf("instances")) {
    EXPECT_EQ(colours.size(), 1U) << instance;
    EXPECT_TRUE(of_instances.insert(*colours.begin()).second) << instance;
  }
  EXPECT_GT(of_instances.size(), 3U);
  std::set<std::uint32_t> of_classes;
  for (const auto& [instance, colours] : coloursOf("classes")) {
    EXPECT_EQ(colours.size(), 1U) << instance;
    of_classes.insert(colours.begin(), colours.end());
  }
  EXPECT_GE(of_classes.size(), 2U);
  EXPECT_LE(of_classes.size(), 4U);  // vegetation, building, high mobility, unknown
}

TEST_F(Offline, ASecondDumpReplacesTheFirst) {
  const std::string dump = "--dump-segments " + (folder_ / "segments").string();
  ASSERT_EQ(offlineOnDrive(dump).status, 0);
  ASSERT_EQ(offlineOnDrive(dump + " --frames 0:2").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "segments/classes/000002.pcd"));
  EXPECT_FALSE(fs::exists(folder_ / "segments/classes/000004.pcd"));
}

TEST_F(Offline, PrintConfigIsTheShippedFile) {
  const Outcome outcome = test::run(std::string(SEGDF_OFFLINE) + " --print-config", folder_.path());
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(contains(outcome.out, "th_dist: 0.1  # [0.01, 5] m"));
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/drive_writer.hpp"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/pcd_stream.hpp"

#include "support/temp_folder.hpp"

namespace segdf {
namespace {

constexpr std::uint32_t kCar = 70005;  // more than a label holds
constexpr std::uint32_t kTree = 70006;

/// A point of the car, one of the tree and one of the ground.
FrameResult frameAt(std::size_t index) {
  FrameResult frame;
  frame.index = index;
  const auto x = static_cast<float>(index);
  frame.scan.points = {{x, 0.0F, 0.0F, 0.1F, 0.0F, -1},
                       {x, 5.0F, 0.0F, 0.2F, 0.0F, -1},
                       {x, 9.0F, 0.0F, 0.3F, 0.0F, -1}};
  frame.labels = {{kCar, PointState::kStatic, ObjectClass::kHighMobility},
                  {kTree, PointState::kStatic, ObjectClass::kVegetation},
                  {0, PointState::kGround, ObjectClass::kNone}};
  for (std::uint32_t id : {kCar, kTree}) {
    InstanceObservation seen;
    seen.id = id;
    seen.points = 1;
    seen.reason = Reason::kVotes;
    frame.instances.push_back(seen);
  }
  return frame;
}

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Three frames; the third says that the car of the first two has left, and counts a point too few.
class RevokingDrive : public ::testing::TestWithParam<double> {
 protected:
  RevokingDrive() {
    Config config;
    config.map.voxel = GetParam();
    DriveWriter writer(folder_ / "result", config);
    writer.add(frameAt(0));
    writer.add(frameAt(1));
    FrameResult last = frameAt(2);
    last.revoked = {{kCar, 0, 1, 2, 1, ObjectClass::kHighMobility, Eigen::Vector3d::Zero()}};
    writer.add(last);
    writer.finish();
  }

  std::vector<MapPoint> pointsOf(const std::string& name) const {
    std::vector<MapPoint> points;
    forEachPoint(folder_ / "result" / name,
                 [&points](const MapPoint& point) { points.push_back(point); });
    return points;
  }

  std::vector<std::uint32_t> labelsOf(const std::string& scan) const {
    return readLabels(folder_ / "result" / "labels" / (scan + ".label"));
  }

  test::TempFolder folder_;
};

TEST_P(RevokingDrive, LabelsOfTheScansBeforeAreDynamic) {
  for (const char* scan : {"000000", "000001"}) {
    EXPECT_EQ(semantic_kitti::classOf(labelsOf(scan)[0]), semantic_kitti::kDynamic);
    EXPECT_EQ(semantic_kitti::instanceOf(labelsOf(scan)[0]), semantic_kitti::shortId(kCar));
    EXPECT_EQ(semantic_kitti::classOf(labelsOf(scan)[1]), semantic_kitti::kVegetation);
    EXPECT_EQ(semantic_kitti::classOf(labelsOf(scan)[2]), semantic_kitti::kRoad);
  }
  EXPECT_EQ(semantic_kitti::classOf(labelsOf("000002")[0]), semantic_kitti::kCar)
      << "there it stands again";
}

TEST_P(RevokingDrive, TheMapLosesThemAndTheDynamicPointsGetThem) {
  std::size_t cars = 0;
  for (const MapPoint& point : pointsOf("static_map.pcd")) {
    cars += point.instance == kCar ? 1 : 0;
    EXPECT_TRUE(point.instance != kCar || point.x == 2.0F);
  }
  EXPECT_EQ(cars, 1U);
  EXPECT_EQ(pointsOf("static_map.pcd").size(), 7U);
  const std::vector<MapPoint> dynamic = pointsOf("dynamic_points.pcd");
  ASSERT_EQ(dynamic.size(), 2U);
  for (const MapPoint& point : dynamic) {
    EXPECT_EQ(point.instance, kCar);
    EXPECT_EQ(point.label, semantic_kitti::kDynamic);
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "result" / "static_map.pcd.remaining"));
}

TEST_P(RevokingDrive, TablesAndReportSaySo) {
  const std::string instances = textOf(folder_ / "result" / "instances.csv");
  EXPECT_NE(instances.find("70005,0,unknown,3,3,2,"), std::string::npos) << instances;
  EXPECT_NE(instances.find(",dynamic,0,0,0,left\n"), std::string::npos) << instances;
  const std::string evidence = textOf(folder_ / "result" / "evidence.csv");
  EXPECT_NE(evidence.find("1,70005,0,dynamic,left,high_mobility,1,"), std::string::npos)
      << evidence;
  const std::string report = textOf(folder_ / "result" / "report.json");
  EXPECT_NE(report.find("\"static\": 4"), std::string::npos) << report;
  EXPECT_NE(report.find("\"dynamic\": 2"), std::string::npos) << report;
}

// Every point on disk, and a map of voxels in memory.
INSTANTIATE_TEST_SUITE_P(DriveWriter, RevokingDrive, ::testing::Values(0.0, 0.1));

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/map_export.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "segdf/io/pcd_stream.hpp"

#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

using test::contains;
using test::errorOf;

const std::vector<MapPoint> kPoints{{1.0F, 2.0F, 3.0F, 0.5F, 10, 70001},
                                    {4.0F, 5.0F, 6.0F, 0.25F, 40, 0}};

InstanceRecord car() {
  InstanceRecord record;
  record.id = 70001;
  record.object_class = ObjectClass::kHighMobility;
  record.frames = 3;
  record.points = 90;
  return record;
}

TEST(MapExport, PcdHoldsTheMapAndTheTableLiesBeside) {
  const test::TempFolder folder;
  exportMap(folder / "town.pcd", kPoints, {car()});
  std::vector<MapPoint> read;
  forEachPoint(folder / "town.pcd", [&read](const MapPoint& point) { read.push_back(point); });
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(std::memcmp(read.data(), kPoints.data(), 2 * sizeof(MapPoint)), 0);
  const std::string table = test::readText(folder / "town_instances.csv");
  EXPECT_TRUE(contains(table, "id,parent,class,frames"));
  EXPECT_TRUE(contains(table, "70001,0,high_mobility,3,90"));
}

TEST(MapExport, PlyHoldsTheMap) {
  const test::TempFolder folder;
  exportMap(folder / "town.ply", kPoints, {});
  const std::string text = test::readText(folder / "town.ply");
  const std::string end = "property uint instance\nend_header\n";
  EXPECT_EQ(text.rfind("ply\nformat binary_little_endian 1.0\nelement vertex 2\n", 0), 0U);
  const std::size_t start = text.find(end) + end.size();
  ASSERT_EQ(text.size() - start, 2 * sizeof(MapPoint));
  EXPECT_EQ(std::memcmp(text.data() + start, kPoints.data(), 2 * sizeof(MapPoint)), 0);
}

TEST(MapExport, NothingThatExistsIsTouched) {
  const test::TempFolder folder;
  std::ofstream(folder / "town.pcd") << "precious";
  EXPECT_TRUE(
      contains(errorOf([&] { exportMap(folder / "town.pcd", kPoints, {}); }), "left alone"));
  EXPECT_EQ(test::readText(folder / "town.pcd"), "precious");
  std::ofstream(folder / "city_instances.csv") << "precious";
  EXPECT_TRUE(contains(errorOf([&] { exportMap(folder / "city.ply", kPoints, {}); }),
                       "city_instances.csv exists"));
  EXPECT_FALSE(std::filesystem::exists(folder / "city.ply"));
}

TEST(MapExport, PathThatCannotBeMeantIsRefused) {
  const test::TempFolder folder;
  EXPECT_TRUE(contains(errorOf([&] { exportMap("map.pcd", kPoints, {}); }), "no absolute path"));
  EXPECT_TRUE(contains(errorOf([&] { exportMap("", kPoints, {}); }), "no absolute path"));
  EXPECT_TRUE(contains(errorOf([&] { exportMap(folder / "map.las", kPoints, {}); }),
                       "neither in .pcd nor in .ply"));
  EXPECT_TRUE(contains(errorOf([&] { exportMap(folder / "missing/map.pcd", kPoints, {}); }),
                       "No such file or directory"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(MapExport, KilledAtAnyMomentItLeavesAWholeMapOrNone) {
  const test::TempFolder folder;
  const std::vector<MapPoint> points(1'000'000);  // 24 MB: some 10 ms to write
  int absent = 0;
  for (int round = 0; round < 12; ++round) {
    const std::filesystem::path map = folder / ("map" + std::to_string(round) + ".pcd");
    const pid_t child = fork();
    if (child == 0) {
      exportMap(map, points, {car()});
      _exit(0);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    if (!std::filesystem::exists(map)) {
      ++absent;
      continue;
    }
    std::size_t read = 0;
    EXPECT_NO_THROW(forEachPoint(map, [&read](const MapPoint&) { ++read; }));
    EXPECT_EQ(read, points.size());
    EXPECT_TRUE(std::filesystem::exists(instanceFileOf(map)));
  }
  EXPECT_GT(absent, 0) << "the first is killed before it could begin";
}

TEST(MapExport, PathIsTakenLiterally) {
  const test::TempFolder folder;
  exportMap(folder / "$HOME ~ *.pcd", kPoints, {});
  EXPECT_TRUE(std::filesystem::exists(folder / "$HOME ~ *.pcd"));
}

}  // namespace
}  // namespace segdf

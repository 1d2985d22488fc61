// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/pcd_stream.hpp"

#include "drive_fixture.hpp"
#include <nlohmann/json.hpp>

namespace segdf {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using test::contains;
using test::Outcome;

class Evaluate : public test::DriveFixture {
 protected:
  Outcome evaluateWith(const std::string& arguments) const {
    return test::run(std::string(SEGDF_EVALUATE) + " --kitti " + drive().string() + " " + arguments,
                     folder_.path());
  }
  Outcome evaluate(const fs::path& labels, const std::string& more = "") const {
    return evaluateWith("--labels " + labels.string() + " " + more);
  }
  Outcome evaluateMap(const fs::path& map, const std::string& more = "") const {
    return evaluateWith("--map " + map.string() + " " + more);
  }
  Json jsonOf(const std::string& arguments) const {
    const Outcome outcome = evaluateWith(arguments + " --json " + (folder_ / "s.json").string());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Json::parse(test::readText(folder_ / "s.json"));
  }
  void expectOneLine(const Outcome& outcome, const std::string& part) const {
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.errorLines("error: "), 1) << outcome.err;
    EXPECT_EQ(outcome.errorLines(""), 1) << "nothing but that line: " << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
  }
  fs::path text(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }
  /// The run's map with its points raised, written by PCL without any other field.
  fs::path raisedMap(float metres, bool ascii) const {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    forEachPoint(result() / "static_map.pcd", [&](const MapPoint& p) {
      cloud.push_back({p.x, p.y, p.z + metres});
    });
    const fs::path file = folder_ / "raised.pcd";
    if (ascii) pcl::PCDWriter().writeASCII(file.string(), cloud, 9);
    if (!ascii) pcl::PCDWriter().writeBinaryCompressed(file.string(), cloud);
    return file;
  }
};

TEST_F(Evaluate, TheTruthScoresItselfAsStaticKeptAndNothingRemoved) {
  // Truth labels are neither 0 nor 251: everything counts as kept.
  const Outcome outcome = evaluate(drive() / "labels", "--json " + (folder_ / "s.json").string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "by point index"));
  EXPECT_TRUE(contains(outcome.out, "SA 100.00  DA 0.00"));
  EXPECT_TRUE(contains(outcome.out, "parked SA -")) << "no parked movable: no figure";
  EXPECT_TRUE(contains(outcome.out, "instances removed 0 of 1"));
  EXPECT_TRUE(contains(test::readText(folder_ / "s.json"), "\"parked_SA\": null"));
}

TEST_F(Evaluate, ARunIsScored) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const Outcome outcome = evaluate(result() / "labels");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "instances removed 1 of 1"));
}

TEST_F(Evaluate, EveryProtocolIsNamed) {
  const Outcome all = evaluate(drive() / "labels", "--protocol all");
  EXPECT_EQ(all.status, 0) << all.err;
  for (const char* name :
       {"by point index", "draft's section IV", "ERASOR, voxel-wise", "DynamicMap, nearest"}) {
    EXPECT_TRUE(contains(all.out, name));
  }
  EXPECT_EQ(evaluate(drive() / "labels", "--protocol all --threads 3").out, all.out);
  const Outcome one = evaluate(drive() / "labels", "--protocol erasor");
  EXPECT_FALSE(contains(one.out, "by point index"));
  EXPECT_TRUE(contains(one.out, "PR 100.00  RR 0.00  F1 0.0000")) << "nothing was removed";
}

TEST_F(Evaluate, PointsThatNobodyJudgedCountForErasorUnlessLeftOut) {
  std::vector<std::uint32_t> labels = readLabels(drive() / "labels" / "000000.label");
  const auto voxels = [&](const std::string& arguments) {
    const Json erasor = jsonOf(arguments + " --protocol erasor")["erasor"];
    return erasor["static_voxels"].get<int>();
  };
  const std::string own = "--labels " + (drive() / "labels").string();
  const int before = voxels(own);
  EXPECT_EQ(voxels(own + " --judged-only"), before) << "the simulator judges every point";
  std::fill(labels.begin(), labels.end(), 0U);
  writeLabels(drive() / "labels" / "000000.label", labels);
  EXPECT_GT(voxels(own), voxels(own + " --judged-only")) << "the first scan is judged no more";
}

TEST_F(Evaluate, LabelsByIndexAndTheSameResultAsAMapAgree) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const std::string labels = "--labels " + (result() / "labels").string();
  const std::string map = "--map " + (result() / "static_map.pcd").string();
  const Json index = jsonOf(labels);
  const Json by_labels = jsonOf(labels + " --protocol dynamicmap")["dynamicmap"];
  const Json by_map = jsonOf(map)["dynamicmap"];
  EXPECT_EQ(by_labels, by_map) << "the map holds exactly the points that the labels keep";
  // A kept point is in the map itself, so a neighbour can only add kept points.
  EXPECT_GE(by_map["SA"], index["SA"]);
  EXPECT_LE(by_map["DA"], index["DA"]);
  // Documented tolerance: points that change sides are those within 0.05 m of a kept one.
  EXPECT_NEAR(by_map["SA"], index["SA"], 1.0);
  EXPECT_NEAR(by_map["DA"], index["DA"], 5.0);
}

TEST_F(Evaluate, MapsOfAnyLayoutScoreTheSame) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const std::string own = evaluateMap(result() / "static_map.pcd", "--protocol all").out;
  EXPECT_TRUE(contains(own, "ERASOR"));
  EXPECT_EQ(evaluateMap(raisedMap(0.0F, false), "--protocol all").out, own) << "compressed, xyz";
  EXPECT_EQ(evaluateMap(raisedMap(0.0F, true), "--protocol all").out, own) << "ascii, xyz";
}

TEST_F(Evaluate, AMapInAnotherFrameIsToldAndCanBeMoved) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const fs::path raised = raisedMap(1.7F, false);
  const Outcome refused = evaluateMap(raised);
  expectOneLine(refused, "the map does not lie on the truth");
  EXPECT_TRUE(contains(refused.err, "--map-pose 0 0 -1.")) << "it names the way back";
  const Outcome moved = evaluateMap(raised, "--map-pose 0 0 -1.7 0 0 0");
  EXPECT_EQ(moved.status, 0) << moved.err;
  EXPECT_TRUE(contains(moved.out, "instances removed 1 of 1"));
  expectOneLine(evaluateMap(raised, "--map-pose 500 0 0 0 0 0"), "give --map-pose");
}

TEST_F(Evaluate, LabelsOfTheMapItselfCanBeUsed) {
  ASSERT_EQ(offlineOnDrive().status, 0);
  const fs::path map = result() / "static_map.pcd";
  // segdf's own labels know no moving class, so that nothing dynamic can remain.
  const Outcome own = evaluateMap(map, "--protocol erasor --map-labels label");
  EXPECT_TRUE(contains(own.out, "RR 100.00")) << own.err;
  expectOneLine(evaluateMap(map, "--protocol erasor --map-labels class"),
                "no field 'class'; it has: x y z intensity label instance");
  const fs::path floats = text("f.pcd",
                               "VERSION 0.7\nFIELDS x y z l\nSIZE 4 4 4 4\nTYPE F F F F\n"
                               "COUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n"
                               "1 2 3 16777468\n");  // instance 256 of class 252
  expectOneLine(evaluateMap(floats, "--map-labels l"), "a float32 cannot hold");
}

TEST_F(Evaluate, APartOfADriveIsRunAndScoredAsTheSamePart) {
  ASSERT_EQ(offlineOnDrive("--frames 0:4:2").status, 0);
  EXPECT_TRUE(fs::exists(result() / "labels/000002.label"));
  EXPECT_FALSE(fs::exists(result() / "labels/000003.label"));
  const Json part = jsonOf("--labels " + (result() / "labels").string() + " --frames 0:4:2");
  EXPECT_EQ(part["scans"], 3);
  // Labels of the whole drive serve for a part of it as well.
  const Json truth = jsonOf("--labels " + (drive() / "labels").string() + " --frames 0:4:2");
  EXPECT_EQ(truth["points"], part["points"]);
  expectOneLine(evaluate(result() / "labels"), "3 label files");
  expectOneLine(evaluate(result() / "labels", "--frames 0:5"), "has 5 scans (0 to 4)");
  expectOneLine(evaluate(result() / "labels", "--frames 4:0"), "frames '4:0' are no range");
}

TEST_F(Evaluate, SeveralDrivesAreScoredOneByOne) {
  const std::string labels = (drive() / "labels").string();
  const Json both = jsonOf(drive().string() + " --labels " + labels + " " + labels);
  ASSERT_EQ(both["drives"].size(), 2U);
  EXPECT_EQ(both["drives"][0], both["drives"][1]);
  expectOneLine(evaluateWith(drive().string() + " --labels " + labels), "2 drives (--kitti) but 1");
}

TEST_F(Evaluate, MixedUpFoldersGetOneLine) {
  EXPECT_TRUE(contains(evaluate(folder_ / "none").err, "no folder"));
  fs::remove(drive() / "labels/000004.label");
  expectOneLine(evaluate(drive() / "labels"), "4 label files");
  writeLabels(drive() / "labels/000004.label", {1, 2, 3});
  EXPECT_TRUE(contains(evaluate(drive() / "labels").err, "000004.label has 3 labels"));
}

TEST_F(Evaluate, AMissingScanGetsOneLine) {
  fs::remove(scanFile("000002"));
  expectOneLine(evaluate(drive() / "labels"), "5 poses for 4 scans");
}

TEST_F(Evaluate, BadMapsGetOneLine) {
  expectOneLine(evaluateMap(folder_ / "none.pcd"), "no map");
  expectOneLine(evaluateMap(text("a.pcd", "not a map\n")), "truncated or no PCD file");
  const std::string rest = "SIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nHEIGHT 1\nWIDTH ";
  expectOneLine(evaluateMap(text("b.pcd", "VERSION 0.7\nFIELDS x y i\n" + rest +
                                              "1\nPOINTS 1\nDATA ascii\n1 2 3\n")),
                "no field 'z'; it has: x y i");
  const std::string xyz = "VERSION 0.7\nFIELDS x y z\n" + rest;
  expectOneLine(evaluateMap(text("c.pcd", xyz + "0\nPOINTS 0\nDATA ascii\n")), "holds no point");
  expectOneLine(evaluateMap(text("d.pcd", xyz + "100\nPOINTS 100\nDATA binary\nabc")),
                "truncated or no PCD file");
}

TEST_F(Evaluate, BadOptionsGetOneLine) {
  EXPECT_EQ(evaluateWith("").status, 2) << "neither labels nor map";
  EXPECT_EQ(evaluate(drive() / "labels", "--protocol best").status, 2);
  ASSERT_EQ(offlineOnDrive().status, 0);
  expectOneLine(evaluateMap(result() / "static_map.pcd", "--protocol index"), "needs --labels");
}

TEST_F(Evaluate, NothingToScoreIsAnError) {
  expectOneLine(evaluate(drive() / "labels", "--range 0.1"), "no point");
}

}  // namespace
}  // namespace segdf

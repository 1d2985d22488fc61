// SPDX-License-Identifier: BSD-3-Clause
// segdf_calibrate_classes as a user calls it.
#include <fstream>

#include "segdf/io/config_yaml.hpp"

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class CalibrateClasses : public test::DriveFixture {
 protected:
  Outcome calibrate(const std::string& arguments) const {
    return test::run(std::string(SEGDF_CALIBRATE_CLASSES) + " " + arguments, folder_.path());
  }
  fs::path table() const { return folder_ / "table.txt"; }
  fs::path labelFile(const std::string& number) const {
    return drive() / "labels" / (number + ".label");
  }
  void expectFailure(const Outcome& outcome, int status, const std::string& part) const {
    expectError(outcome, status, part);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(table()));
  }
  /// Percent of movable points tested, as the line that starts so tells.
  static double tested(const std::string& out, const std::string& line) {
    return std::stod(out.substr(out.find(line) + line.size()));
  }
};

TEST_F(CalibrateClasses, ProposesThresholdsThatKeepWhatMoves) {
  const fs::path simulated = folder_ / "simulated";
  ASSERT_EQ(
      test::run(std::string(SEGDF_SIMULATE) +
                    " --seed 3 --scans 4 --rate 0.5 --sensor vlp16 --output " + simulated.string(),
                folder_.path())
          .status,
      0);
  const Outcome outcome = calibrate(simulated.string() + " --table " + table().string());
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  // 99 %, or as many as before where fewer are kept.
  EXPECT_GE(tested(outcome.out, "# proposal: "), std::min(99.0, tested(outcome.out, "# now: ")));
  Config config = sensorConfig("vlp16");
  EXPECT_NO_THROW(applyYaml(config, outcome.out, "what is printed")) << outcome.out;
  const std::string quantiles = test::readText(table());
  EXPECT_TRUE(contains(quantiles, "feature truth range_from_m range_to_m segments q05"));
  EXPECT_TRUE(contains(quantiles, "\nlength movable 0 10 "));
  EXPECT_TRUE(contains(quantiles, "\ntopcut building "));
}

TEST_F(CalibrateClasses, SameTextAgainAndOnTwoThreads) {
  const Outcome once = calibrate(drive().string());
  ASSERT_EQ(once.status, 0) << once.err;
  EXPECT_EQ(calibrate(drive().string() + " --threads 2").out, once.out);
}

TEST_F(CalibrateClasses, NoDrive) { expectFailure(calibrate(""), 2, "drives is required"); }

TEST_F(CalibrateClasses, MissingFolder) {
  expectFailure(calibrate("/nowhere --table " + table().string()), 1,
                "no folder /nowhere/velodyne");
}

TEST_F(CalibrateClasses, ADriveWithoutLabels) {
  fs::remove_all(drive() / "labels");
  expectFailure(calibrate(drive().string()), 1, "labels/000000.label");
}

TEST_F(CalibrateClasses, LabelsThatDoNotFitTheScan) {
  fs::resize_file(labelFile("000003"), 400);
  expectFailure(calibrate(drive().string() + " --table " + table().string()), 1,
                "000003.label has 100 labels for a scan of");
}

TEST_F(CalibrateClasses, AnUnknownParameter) {
  std::ofstream(folder_ / "my.yaml") << "class: {tal: 1}\n";
  expectFailure(calibrate(drive().string() + " --config " + (folder_ / "my.yaml").string()), 1,
                "unknown parameter 'class.tal'");
}

TEST_F(CalibrateClasses, ATableThatCannotBeWritten) {
  expectFailure(calibrate(drive().string() + " --table /nowhere/table.txt"), 1,
                "/nowhere/table.txt");
}

}  // namespace
}  // namespace segdf

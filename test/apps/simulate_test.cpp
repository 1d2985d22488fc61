// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class Simulate : public ::testing::Test {
 protected:
  Outcome simulate(const std::string& arguments) const {
    return test::run(std::string(SEGDF_SIMULATE) + " --sensor vlp16 --scans 3 " + arguments,
                     folder_.path());
  }

  test::TempFolder folder_;
};

TEST_F(Simulate, FolderAndBagAreFilteredByTheOfflineRunner) {
  const Outcome made =
      simulate("--output " + (folder_ / "d").string() + " --bag " + (folder_ / "d.bag").string());
  ASSERT_EQ(made.status, 0) << made.err;
  for (const std::string& input :
       {"--kitti " + (folder_ / "d").string(), "--bag " + (folder_ / "d.bag").string()}) {
    const Outcome outcome = test::run(
        std::string(SEGDF_OFFLINE) + " " + input + " --output " + (folder_ / "out").string(),
        folder_.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "recognised sensor vlp16"));
    EXPECT_TRUE(contains(outcome.out, "3 of 3 scans mapped"));
  }
}

TEST_F(Simulate, TheSameSeedGivesTheSameFiles) {
  ASSERT_EQ(simulate("--seed 7 --output " + (folder_ / "a").string()).status, 0);
  ASSERT_EQ(simulate("--seed 7 --threads 2 --output " + (folder_ / "b").string()).status, 0);
  for (const char* name :
       {"velodyne/000002.bin", "labels/000002.label", "poses.txt", "times.txt"}) {
    EXPECT_EQ(test::readText((folder_ / "a") / name), test::readText((folder_ / "b") / name))
        << name;
  }
}

TEST_F(Simulate, ADriveIsNeverOverwritten) {
  ASSERT_EQ(simulate("--output " + (folder_ / "a").string()).status, 0);
  const Outcome again = simulate("--output " + (folder_ / "a").string());
  EXPECT_EQ(again.status, 1);
  EXPECT_EQ(again.errorLines("error: "), 1);
  EXPECT_TRUE(contains(again.err, "holds scans already"));
}

TEST_F(Simulate, ScenesAreListedByNameAndWhatTheyAreAbout) {
  const Outcome listed = test::run(std::string(SEGDF_SIMULATE) + " --list-scenes", folder_.path());
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_TRUE(contains(listed.out, "s03_oncoming  S3: oncoming traffic"));
  EXPECT_TRUE(contains(listed.out, "mixed  Mixed drive"));
}

TEST_F(Simulate, AUsersOwnSceneIsDriven) {
  std::ofstream(folder_ / "mine.yaml") << "duration: 0.4\nmovers:\n"
                                          "  - {kind: bus, path: [[20, 2], [-20, 2]], speed: 7}\n";
  const Outcome made =
      test::run(std::string(SEGDF_SIMULATE) + " --sensor vlp16 --scene " +
                    (folder_ / "mine.yaml").string() + " --output " + (folder_ / "d").string(),
                folder_.path());
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "4 scans of vlp16"));
}

TEST_F(Simulate, ABadSceneFileGetsOneLineThatNamesItsFault) {
  std::ofstream(folder_ / "bad.yaml") << "duration: 5\nego: {sped: 3}\n";
  const Outcome outcome = simulate("--output " + (folder_ / "d").string() + " --scene " +
                                   (folder_ / "bad.yaml").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.errorLines("error: "), 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "bad.yaml: unknown key 'ego.sped'"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d"));
  const Outcome none = simulate("--output d --scene s99_nowhere");
  EXPECT_TRUE(contains(none.err, "scene 's99_nowhere' is neither built in"));
}

TEST_F(Simulate, SkewedSweepsGoIntoBagsOnly) {
  EXPECT_EQ(simulate("--skewed --output " + (folder_ / "d").string()).status, 2);
  const Outcome made = simulate("--skewed --bag " + (folder_ / "d.bag").string());
  EXPECT_EQ(made.status, 0) << made.err;
}

TEST_F(Simulate, DrivesAreDescribedInFigures) {
  ASSERT_EQ(simulate("--output " + (folder_ / "d").string()).status, 0);
  const Outcome table = test::run(
      std::string(SEGDF_SCAN_STATISTICS) + " --sensor vlp16 --kitti " + (folder_ / "d").string(),
      folder_.path());
  EXPECT_EQ(table.status, 0) << table.err;
  for (const char* row :
       {"| points a scan | ", "| ground by the labels, % | ",
        "| neighbour in the next scan, median, m | 0.", "| intensity of road, 5 to 10 m | "}) {
    EXPECT_TRUE(contains(table.out, row));
  }
  const Outcome none =
      test::run(std::string(SEGDF_SCAN_STATISTICS) + " --kitti " + (folder_ / "none").string(),
                folder_.path());
  EXPECT_EQ(none.status, 1);
  EXPECT_EQ(none.errorLines("error: "), 1) << none.err;
}

TEST_F(Simulate, BadOptionsGetOneLine) {
  EXPECT_EQ(simulate("").status, 2);
  EXPECT_EQ(simulate("--output x --speed fast").status, 2);
  EXPECT_EQ(simulate("--output x --sensor hdl65").errorLines("error: "), 1);
}

}  // namespace
}  // namespace segdf

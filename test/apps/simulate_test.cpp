// SPDX-License-Identifier: BSD-3-Clause
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

TEST_F(Simulate, BadOptionsGetOneLine) {
  EXPECT_EQ(simulate("").status, 2);
  EXPECT_EQ(simulate("--output x --speed fast").status, 2);
  EXPECT_EQ(simulate("--output x --sensor hdl65").errorLines("error: "), 1);
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>

#include "segdf/io/label_file.hpp"

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class Evaluate : public test::DriveFixture {
 protected:
  Outcome evaluate(const fs::path& labels, const std::string& more = "") const {
    return test::run(std::string(SEGDF_EVALUATE) + " --kitti " + drive().string() + " --labels " +
                         labels.string() + " " + more,
                     folder_.path());
  }
};

TEST_F(Evaluate, TheTruthScoresItselfAsStaticKeptAndNothingRemoved) {
  // Truth labels are neither 0 nor 251: everything counts as kept.
  const Outcome outcome = evaluate(drive() / "labels", "--json " + (folder_ / "s.json").string());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
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

TEST_F(Evaluate, MixedUpFoldersGetOneLine) {
  EXPECT_TRUE(contains(evaluate(folder_ / "none").err, "no folder"));
  fs::remove(drive() / "labels/000004.label");
  const Outcome missing = evaluate(drive() / "labels");
  EXPECT_EQ(missing.status, 1);
  EXPECT_EQ(missing.errorLines("error: "), 1);
  EXPECT_TRUE(contains(missing.err, "4 label files"));
  writeLabels(drive() / "labels/000004.label", {1, 2, 3});
  EXPECT_TRUE(contains(evaluate(drive() / "labels").err, "000004.label has 3 labels"));
}

TEST_F(Evaluate, NothingToScoreIsAnError) {
  const Outcome outcome = evaluate(drive() / "labels", "--range 0.1");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(contains(outcome.err, "no point"));
}

}  // namespace
}  // namespace segdf

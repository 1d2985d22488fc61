// SPDX-License-Identifier: BSD-3-Clause
// segdf_validate_bag as a user calls it: exit status, and what goes where. Its findings are tested
// one by one in ros/bag_check_test.cpp.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "ros/street_bag.hpp"
#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;
using test::StreetBag;

class ValidateBag : public ::testing::Test {
 protected:
  std::string bag() const { return (folder_ / "drive.bag").string(); }
  Outcome validate(const std::string& arguments) const {
    return test::run(std::string(SEGDF_VALIDATE_BAG) + " " + arguments, folder_.path());
  }
  void expectError(const Outcome& outcome, const std::string& part) const {
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines("error: "), 1) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, part));
    EXPECT_FALSE(contains(outcome.out, "roslaunch"));
  }

  test::TempFolder folder_;
};

TEST_F(ValidateBag, GoodBagGivesTheCommandsThatWork) {
  StreetBag::registered().write(bag());
  const Outcome outcome = validate("--all --bag " + bag());
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_TRUE(contains(outcome.out, "the bag is good; run one of\n"));
  EXPECT_TRUE(contains(outcome.out, "\n  roslaunch segdf segdf.launch bag:=" + bag()));
  const std::size_t begin = outcome.out.find("segdf_offline ");
  ASSERT_NE(begin, std::string::npos);
  const std::string arguments =
      outcome.out.substr(begin + 14, outcome.out.find('\n', begin) - begin - 14);
  const Outcome offline = test::run(
      "cd " + folder_.path().string() + " && " + SEGDF_OFFLINE + " " + arguments, folder_.path());
  EXPECT_EQ(offline.status, 0) << offline.err;
  EXPECT_TRUE(fs::exists(folder_ / "result/static_map.pcd"));
}

TEST_F(ValidateBag, WarningsGiveStatus3) {
  StreetBag street = StreetBag::registered();
  street.poses.pop_back();
  street.write(bag());
  const Outcome outcome = validate("--bag " + bag());
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.errorLines("warning: "), 1) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "the bag can be used, with the warnings above; run one of"));
}

TEST_F(ValidateBag, UnusableBagGivesStatus1AndWhatWasSeen) {
  StreetBag street = StreetBag::registered();
  street.poses.clear();
  street.write(bag());
  const Outcome outcome = validate("--bag " + bag());
  expectError(outcome, "has no topic '/lio_sam/mapping/odometry'");
  EXPECT_TRUE(contains(outcome.out, "(sensor_msgs/PointCloud2, 12 messages)"));
  EXPECT_TRUE(contains(outcome.out, "the bag cannot be used"));
}

TEST_F(ValidateBag, MissingFile) { expectError(validate("--bag /nowhere.bag"), "does not exist"); }

TEST_F(ValidateBag, NoBag) {
  std::ofstream(bag()) << "text\n";
  expectError(validate("--bag " + bag()), "it is no ROS 1 bag");
}

TEST_F(ValidateBag, Ros2Bag) {
  std::ofstream(bag()) << "SQLite format 3 and more";
  expectError(validate("--bag " + bag()), "it is a ROS 2 bag: convert it");
}

TEST_F(ValidateBag, TruncatedBag) {
  StreetBag::registered().write(bag());
  fs::resize_file(bag(), fs::file_size(bag()) / 2);
  expectError(validate("--bag " + bag()), "run 'rosbag reindex " + bag() + "'");
}

TEST_F(ValidateBag, WrongCommandLine) {
  EXPECT_EQ(validate("").status, 2);
  EXPECT_EQ(validate("--bag x --every").status, 2);
}

}  // namespace
}  // namespace segdf

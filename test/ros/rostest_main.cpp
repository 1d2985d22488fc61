// SPDX-License-Identifier: BSD-3-Clause
// What rostest starts: a node, named by the launch file, that runs all tests of its program.
#include <gtest/gtest.h>

#include <ros/init.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "rostest");
  return RUN_ALL_TESTS();
}

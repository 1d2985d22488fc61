// SPDX-License-Identifier: BSD-3-Clause
// Runs under rostest (nodelet_saving.test): writing a map, filtering a drive and hearing scans do
// not wait for each other, even if the manager has one thread. A named pipe stands where one of
// them writes, which is thus stuck for as long as the test wants to look at the others.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <ros/ros.h>

#include <segdf/SaveMap.h>

#include "ros/manager.hpp"
#include "ros/node_client.hpp"
#include "ros/scan_publisher.hpp"
#include "support/expect_error.hpp"
#include "support/program.hpp"
#include "support/temp_folder.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;

constexpr int kScans = 10;              // more than a frame waits for
constexpr std::size_t kPoints = 10000;  // their map is larger than what a pipe holds, 64 KiB

/// Keeps who writes this file waiting until it is read.
class Pipe {
 public:
  explicit Pipe(fs::path path) : path_(std::move(path)) {
    if (mkfifo(path_.c_str(), 0600) != 0) throw std::runtime_error("no pipe " + path_.string());
  }
  /// All that is written.
  std::string read() const {
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path path_;
};

SaveMapResponse save(const fs::path& map) {
  SaveMap call;
  call.request.destination = map;
  EXPECT_TRUE(ros::service::call("/segdf/save_map", call));
  return call.response;
}

template <class Result>
bool isReady(const std::future<Result>& result) {
  return result.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

class NodeletSaving : public ::testing::Test {
 protected:
  void SetUp() override {
    ros::param::set("/segdf/df/window", 2);  // frames come while the drive goes on
    ros::param::set("/segdf/output_dir", results().string());
    test::loadNode();
    ASSERT_TRUE(test::spinUntil([this] { return client_.isConnected(); }));
  }
  void TearDown() override { test::unloadNode(); }

  fs::path results() const { return folder_ / "results"; }

  /// Waits for a frame's report, and so for those before it.
  bool waitForFrame(int index) const {
    return test::spinUntil([this, index] {
      return !client_.reports.empty() && static_cast<int>(client_.reports.back().index) >= index;
    });
  }

  const test::TempFolder folder_;
  test::NodeClient client_;
  test::ScanPublisher scans_{kPoints};
};

TEST_F(NodeletSaving, FramesArePublishedWhileAMapIsWritten) {
  scans_.publish(kScans);
  ASSERT_TRUE(test::NodeClient::flushUntil(kScans));
  ASSERT_TRUE(save(folder_ / "before.ply").success);
  const Pipe pipe(folder_ / "town.ply.partial");
  std::future<SaveMapResponse> saving = std::async(std::launch::async, save, folder_ / "town.ply");
  // The table comes before the map: the save is at work.
  EXPECT_TRUE(test::spinUntil([this] { return fs::exists(folder_ / "town_instances.csv"); }));
  scans_.publish(kScans);
  EXPECT_TRUE(waitForFrame(kScans)) << "the first of those that came after the request";
  EXPECT_FALSE(isReady(saving));
  const std::string map = pipe.read();
  const SaveMapResponse response = saving.get();
  EXPECT_TRUE(response.success) << response.message;
  EXPECT_TRUE(map == test::readText(folder_ / "before.ply")) << "not the map that was asked for";
}

TEST_F(NodeletSaving, AMapIsWrittenWhileTheFilterIsBusy) {
  scans_.publish(kScans);
  ASSERT_TRUE(client_.waitUntilReceived(kScans));
  // The session's folder is there from the first frame on; its table is written at the end.
  ASSERT_TRUE(test::spinUntil([this] { return fs::exists(results() / "partial" / "labels"); }));
  const Pipe pipe(results() / "partial" / "instances.csv.partial");
  std::future<std::string> flushing = std::async(std::launch::async, test::NodeClient::flush);
  EXPECT_TRUE(waitForFrame(kScans - 1)) << "after the last frame come the files";
  scans_.publish(1);
  EXPECT_TRUE(client_.waitUntilReceived(kScans + 1)) << "messages come while a service waits";
  std::future<SaveMapResponse> saving = std::async(std::launch::async, save, folder_ / "town.pcd");
  EXPECT_TRUE(test::spinUntil([&saving] { return isReady(saving); }));
  EXPECT_FALSE(isReady(flushing));
  EXPECT_TRUE(test::contains(pipe.read(), "id,parent,class"));
  EXPECT_TRUE(saving.get().success);
  EXPECT_TRUE(test::contains(flushing.get(), std::to_string(kScans) + " frames published"));
}

}  // namespace
}  // namespace segdf

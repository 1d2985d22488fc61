// SPDX-License-Identifier: BSD-3-Clause
// Filters a drive from a bag or a KITTI folder without a ROS master.
#include <iostream>
#include <string>
#include <vector>

#include <ros/init.h>

#include "segdf/io/config_yaml.hpp"

#include "offline_runner.hpp"
#include "run_app.hpp"

namespace {

using segdf::apps::OfflineOptions;

void addOptions(CLI::App& app, OfflineOptions& options) {
  auto* print = app.add_flag("--print-config", "print all parameters with their defaults and stop");
  auto* input = app.add_option_group("input");
  input->add_option("--bag", options.bag, "ROS 1 bag with clouds and odometry");
  input->add_option("--kitti", options.kitti,
                    "folder with velodyne/, poses.txt and calib.txt or "
                    "poses_lidar.txt");
  input->require_option(0, 1);
  app.add_option("--output", options.output, "folder for the results");
  app.add_option("--sensor", options.sensor,
                 "hdl64, hdl32, vlp16 or os1_64; recognised if not given");
  app.add_option("--config", options.config, "YAML with parameters that differ from the sensor's");
  app.add_option("--mode", options.mode,
                 "dynamic filter: segdf (default) or literal, the algorithm as printed");
  app.add_option("--threads", options.threads, "worker threads (default 1); same results with any")
      ->check(CLI::Range(1, 256));
  app.add_option("--frames", options.frames,
                 "only these scans of the folder, FIRST:LAST:STEP, ends inclusive");
  app.add_option("--rate", options.rate,
                 "scans a second of a folder without times.txt (default 10)")
      ->check(CLI::PositiveNumber);
  app.add_option("--cloud-topic", options.cloud_topic,
                 "default: LIO-SAM's registered, else deskewed");
  app.add_option("--odometry-topic", options.odometry_topic, "default: LIO-SAM's mapping odometry");
  app.callback([&app, &options, print] {
    if (print->count() > 0) return;
    if (options.bag.empty() && options.kitti.empty()) {
      throw CLI::RequiredError("--bag FILE or --kitti DIR");
    }
    if (!options.frames.empty() && options.kitti.empty()) {
      throw CLI::RequiresError("--frames", "--kitti DIR");
    }
    if (options.output.empty()) throw CLI::RequiredError("--output DIR");
  });
}

/// As a node of a launch file it is told its name, as every node is: left out.
std::vector<std::string> withoutRosArguments(int argc, char** argv) {
  std::vector<std::string> words;
  ros::removeROSArgs(argc, argv, words);
  return words;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> words = withoutRosArguments(argc, argv);
  std::vector<char*> arguments;
  arguments.reserve(words.size());
  for (std::string& word : words) arguments.push_back(word.data());
  CLI::App app("Removes what moves from a LiDAR drive and writes the static instance map.",
               "segdf_offline");
  OfflineOptions options;
  addOptions(app, options);
  return segdf::apps::runApp(app, static_cast<int>(arguments.size()), arguments.data(), [&] {
    if (app.count("--print-config") == 0) return segdf::apps::OfflineRunner(options).run();
    std::cout << segdf::toYaml(segdf::Config{});
    return static_cast<int>(segdf::apps::kOk);
  });
}

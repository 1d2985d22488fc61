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
  addDriveOptions(app, options.input);
  app.add_option("--output", options.output, "folder for the results");
  app.add_option("--dump-segments", options.segments,
                 "folder for a coloured cloud and picture of each scan, by instance and by class");
  app.add_option("--mode", options.mode,
                 "dynamic filter: segdf (default) or literal, the algorithm as printed");
  app.add_option("--threads", options.threads, "worker threads (default 2); same results with any")
      ->check(CLI::Range(1, 256));
  app.callback([&options, print] {
    if (print->count() > 0) return;
    checkDriveOptions(options.input);
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

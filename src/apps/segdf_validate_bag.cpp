// SPDX-License-Identifier: BSD-3-Clause
// Says whether a bag is good for segdf, and how to run segdf on it.
#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <string>

#include "segdf/ros/bag_check.hpp"

#include "run_app.hpp"

namespace {

using segdf::apps::ExitCode;

void addOptions(CLI::App& app, std::string& bag, segdf::BagCheckOptions& options) {
  app.add_option("--bag", bag, "ROS 1 bag with clouds and odometry")->required();
  app.add_option("--cloud-topic", options.topics.cloud,
                 "default: LIO-SAM's registered, else deskewed, else the only one");
  app.add_option("--odometry-topic", options.topics.odometry,
                 "default: LIO-SAM's mapping odometry, else the only one");
  app.add_flag("--all", options.all_scans,
               "look into every scan, not only into " + std::to_string(2 * segdf::kSampledPlaces) +
                   " of them");
  app.footer(
      "Exit status: 0 the bag is good, 1 it cannot be used, 2 wrong command line, 3 it can "
      "be used, with warnings.");
}

void printFacts(const segdf::BagReport& report) {
  std::size_t width = 0;
  for (const auto& [name, text] : report.facts) width = std::max(width, name.size());
  for (const auto& [name, text] : report.facts) {
    std::cout << std::left << std::setw(static_cast<int>(width) + 2) << name << text << '\n';
  }
  std::cout << std::flush;  // before what goes to standard error
}

void printFindings(const segdf::BagReport& report) {
  for (const std::string& text : report.warnings) std::cerr << "warning: " << text << '\n';
  for (const std::string& text : report.errors) std::cerr << "error: " << text << '\n';
}

ExitCode printVerdict(const std::string& bag, const segdf::BagReport& report) {
  if (!report.errors.empty()) {
    std::cout << "the bag cannot be used\n";
    return segdf::apps::kFailed;
  }
  const bool good = report.warnings.empty();
  std::cout << (good ? "the bag is good" : "the bag can be used, with the warnings above")
            << "; run one of\n  " << segdf::offlineCommand(bag, report.topics) << "\n  "
            << segdf::launchCommand(bag, report.topics) << '\n';
  return good ? segdf::apps::kOk : segdf::apps::kPartial;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Checks a bag before segdf is run on it, and says how to run it.",
               "segdf_validate_bag");
  std::string bag;
  segdf::BagCheckOptions options;
  addOptions(app, bag, options);
  return segdf::apps::runApp(app, argc, argv, [&] {
    const segdf::BagReport report = segdf::checkBag(bag, options);
    printFacts(report);
    printFindings(report);
    return static_cast<int>(printVerdict(bag, report));
  });
}

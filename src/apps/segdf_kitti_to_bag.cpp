// SPDX-License-Identifier: BSD-3-Clause
// Writes a KITTI folder as a bag such as LIO-SAM would have recorded.
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/ros/bag_writer.hpp"

#include "run_app.hpp"

namespace {

struct Options {
  std::string kitti;
  std::string output;
  segdf::CloudForm form = segdf::CloudForm::kRegistered;
  double rate = 10.0;
  bool force = false;
};

void addOptions(CLI::App& app, Options& options) {
  const std::map<std::string, segdf::CloudForm> forms{{"registered", segdf::CloudForm::kRegistered},
                                                      {"sensor", segdf::CloudForm::kSensor}};
  app.add_option("--kitti", options.kitti,
                 "folder with velodyne/, poses.txt and calib.txt or poses_lidar.txt")
      ->required();
  app.add_option("--output", options.output, "bag to write")->required();
  app.add_option(
         "--form", options.form,
         "registered: clouds in the odometry frame, x y z intensity (default); sensor: in the "
         "sensor frame, with ring and time")
      ->transform(CLI::CheckedTransformer(forms));
  app.add_option("--rate", options.rate,
                 "scans a second, for a folder without times.txt (default 10)")
      ->check(CLI::PositiveNumber);
  app.add_flag("--force", options.force, "overwrite the bag if it exists");
}

/// The labels of a scan, or none if the folder has none for it.
std::vector<std::uint32_t> readTruth(const std::filesystem::path& file, std::size_t points) {
  if (!std::filesystem::exists(file)) return {};
  std::vector<std::uint32_t> labels = segdf::readLabels(file);
  if (labels.size() == points) return labels;
  throw segdf::IoError("label file " + file.string() + " has " + std::to_string(labels.size()) +
                       " labels for a scan of " + std::to_string(points) +
                       " points: it belongs to another");
}

void convert(const Options& options) {
  segdf::KittiSource source(options.kitti, options.rate);
  segdf::BagWriter writer(options.output, options.form, options.force);
  const std::filesystem::path labels = std::filesystem::path(options.kitti) / "labels";
  std::size_t with_truth = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const segdf::Scan scan = *source.next();
    const auto truth = readTruth(labels / (source.nameOf(i) + ".label"), scan.points.size());
    with_truth += truth.empty() ? 0 : 1;
    writer.add(scan, truth);
  }
  writer.finish();
  std::cout << options.output << ": " << source.size() << " scans, " << with_truth
            << " of them with labels\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Writes a KITTI folder as a bag such as LIO-SAM would have recorded.",
               "segdf_kitti_to_bag");
  Options options;
  addOptions(app, options);
  return segdf::apps::runApp(app, argc, argv, [&options] {
    convert(options);
    return static_cast<int>(segdf::apps::kOk);
  });
}

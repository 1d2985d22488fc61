// SPDX-License-Identifier: BSD-3-Clause
// Shows the features of labelled segments and proposes thresholds of the classes.
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "segdf/classification/features.hpp"
#include "segdf/core/parallel.hpp"
#include "segdf/io/atomic_file.hpp"
#include "segdf/io/config_yaml.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/segmentation/sensor_recognition.hpp"

#include "class_calibration.hpp"
#include "run_app.hpp"

namespace {

namespace fs = std::filesystem;
using namespace segdf;
using apps::ClassCalibration;

struct Options {
  std::vector<std::string> drives;
  std::string sensor;
  std::string config;
  std::string table;
  int threads = 1;
};

Segmentation describedSegments(const Scan& scan, const Config& config, int threads) {
  StageTimes times;
  Segmentation seg = segmentScan(scan, config, threads, times);
  const PointAttributes attributes{scan.points, seg.height, seg.row, seg.column, seg.surfaces};
  parallelFor(seg.segments.size(), threads,
              [&](std::size_t s) { describeSegment(attributes, seg.segments[s]); });
  return seg;
}

Config configFor(const Options& options, const Scan& scan) {
  Config config =
      sensorConfig(options.sensor.empty() ? recogniseSensor(scan).name : options.sensor);
  if (!options.config.empty()) applyYamlFile(config, options.config);
  return config;
}

/// @returns the configuration used for the drive
Config addDrive(const fs::path& drive, const Options& options, ClassCalibration& calibration) {
  KittiSource source(drive);
  Config config;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Scan scan = *source.next();
    if (i == 0) config = configFor(options, scan);
    const fs::path file = drive / "labels" / (source.nameOf(i) + ".label");
    const std::vector<std::uint32_t> truth = readLabels(file);
    if (truth.size() != scan.points.size()) {
      throw IoError("label file " + file.string() + " has " + std::to_string(truth.size()) +
                    " labels for a scan of " + std::to_string(scan.points.size()) + " points");
    }
    calibration.add(describedSegments(scan, config, options.threads), truth);
  }
  return config;
}

void print(const char* what, const ClassCalibration::Score& score) {
  std::cout << "# " << what << ": " << formatNumber(score.movable_kept)
            << " % of movable points tested, " << formatNumber(score.excluded)
            << " % of building and vegetation points excluded\n";
}

/// Prints the thresholds that the proposal changes, as YAML for --config.
class Difference {
 public:
  explicit Difference(const ClassConfig& before) : before_(before) {}

  void number(const char* name, double value, double, double, const char*, const char*) {
    Lookup lookup{name, value};
    ClassConfig::visit(before_, lookup);
    if (lookup.value == value) return;
    std::cout << "  " << name << ": " << formatNumber(value) << "  # was "
              << formatNumber(lookup.value) << '\n';
  }

 private:
  struct Lookup {
    std::string name;
    double value;
    void number(const char* other, double v, double, double, const char*, const char*) {
      if (name == other) value = v;
    }
  };
  const ClassConfig& before_;
};

int run(const Options& options) {
  ClassCalibration calibration;
  Config config;
  for (const std::string& drive : options.drives) config = addDrive(drive, options, calibration);
  if (!options.table.empty()) writeWhole(options.table, calibration.quantiles());
  const ClassConfig proposal = calibration.propose(config.classes);
  std::cout << "# " << calibration.size() << " segments\n";
  print("now", calibration.score(config.classes));
  print("proposal", calibration.score(proposal));
  std::cout << "class:\n";
  Difference difference(config.classes);
  ClassConfig::visit(proposal, difference);
  return apps::kOk;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Shows the features of labelled segments and proposes thresholds of the classes as YAML.",
      "segdf_calibrate_classes");
  Options options;
  app.add_option("drives", options.drives, "folders with velodyne/, labels/ and poses")->required();
  app.add_option("--sensor", options.sensor,
                 "hdl64, hdl32, vlp16 or os1_64; recognised if not given");
  app.add_option("--config", options.config, "YAML with parameters that differ from the sensor's");
  app.add_option("--table", options.table,
                 "also write quantiles of every feature by class and range here");
  app.add_option("--threads", options.threads, "worker threads (default 1)")
      ->check(CLI::Range(1, 256));
  return apps::runApp(app, argc, argv, [&options] { return run(options); });
}

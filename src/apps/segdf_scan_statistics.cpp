// SPDX-License-Identifier: BSD-3-Clause
// Describes the scans of drives in figures, to compare simulated with real ones
// (docs/simulator.md).
#include <cstddef>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "segdf/io/config_yaml.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/pipeline/pipeline.hpp"

#include "run_app.hpp"
#include "scan_statistics.hpp"

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> drives;
  std::string sensor = "hdl64";
  std::size_t scans = 0;
  std::size_t every = 1;
  int threads = 1;
};

std::vector<std::uint32_t> truthOf(const fs::path& drive, const std::string& name, std::size_t n) {
  const fs::path file = drive / "labels" / (name + ".label");
  if (!fs::exists(file)) return {};
  std::vector<std::uint32_t> labels = segdf::readLabels(file);
  if (labels.size() == n) return labels;
  throw segdf::IoError("label file " + file.string() + " has " + std::to_string(labels.size()) +
                       " labels for a scan of " + std::to_string(n) + " points");
}

/// nuScenes writes pulses without return at the sensor and returns from the own roof; KITTI and the
/// simulator write neither.
void dropOwnReturns(segdf::Scan& scan, std::vector<std::uint32_t>& truth) {
  constexpr float kOwn = 1.5F;  // metres
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!(scan.points[i].position().norm() >= kOwn)) continue;
    if (!truth.empty()) truth[kept] = truth[i];
    scan.points[kept++] = scan.points[i];
  }
  scan.points.resize(kept);
  if (!truth.empty()) truth.resize(kept);
}

segdf::apps::ScanStatistics describe(const std::string& drive, const Options& options) {
  segdf::KittiSource source(drive);
  segdf::Pipeline pipeline(segdf::sensorConfig(options.sensor), options.threads);
  segdf::apps::ScanStatistics statistics;
  std::vector<std::vector<std::uint32_t>> truth;
  const auto take = [&](const segdf::FrameResult& frame) {
    statistics.add(frame, truth[frame.index]);
    truth[frame.index] = {};
  };
  std::size_t number = 0;
  while (auto scan = source.next()) {
    const std::size_t i = number++;
    if (i % options.every != 0) continue;
    if (options.scans != 0 && truth.size() == options.scans) break;
    truth.push_back(truthOf(drive, source.nameOf(i), scan->points.size()));
    dropOwnReturns(*scan, truth.back());
    for (const segdf::FrameResult& frame : pipeline.process(std::move(*scan))) take(frame);
  }
  pipeline.flush(take);
  return statistics;
}

void print(const Options& options) {
  std::vector<std::vector<std::pair<std::string, std::optional<double>>>> columns;
  for (const std::string& drive : options.drives)
    columns.push_back(describe(drive, options).rows());
  std::cout << "| |";
  for (const std::string& drive : options.drives) std::cout << ' ' << drive << " |";
  std::cout << "\n|---|";
  for (std::size_t k = 0; k < columns.size(); ++k) std::cout << "---|";
  std::cout << '\n';
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    std::cout << "| " << columns.front()[row].first << " |";
    for (const auto& column : columns) {
      const std::optional<double> value = column[row].second;
      std::ostringstream text;
      text << std::setprecision(value && *value >= 1000.0 ? 6 : 3) << value.value_or(0.0);
      std::cout << ' ' << (value ? text.str() : "-") << " |";
    }
    std::cout << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Describes the scans of drives in figures, a table column each.",
               "segdf_scan_statistics");
  Options options;
  app.add_option("--kitti", options.drives, "drives in KITTI's layout; labels are used if there")
      ->required();
  app.add_option("--sensor", options.sensor, "hdl64 (default), hdl32, vlp16 or os1_64")
      ->check(CLI::IsMember(segdf::knownSensors()));
  app.add_option("--scans", options.scans, "look at so many scans only (default 0: all)");
  app.add_option("--every", options.every, "look at every so many-th scan (default 1)")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--threads", options.threads, "worker threads (default 1)")
      ->check(CLI::Range(1, 256));
  return segdf::apps::runApp(app, argc, argv, [&options] {
    print(options);
    return static_cast<int>(segdf::apps::kOk);
  });
}

// SPDX-License-Identifier: BSD-3-Clause
// Compares the labels of a run with ground truth.
#include <algorithm>
#include <array>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"
#include "segdf/evaluation/index_protocol.hpp"
#include "segdf/io/atomic_file.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"

#include "run_app.hpp"
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using segdf::IndexProtocol;
using segdf::IoError;
using segdf::Share;

constexpr std::array<const char*, IndexProtocol::kMovingClasses> kClassNames{
    "car", "bicyclist", "person", "motorcyclist", "on-rails", "bus", "truck", "other-vehicle"};

struct Options {
  std::string kitti;
  std::string labels;
  std::string json;
  double range = 50.0;
};

std::size_t countLabels(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw IoError("no folder " + folder.string() + " with .label files");
  return static_cast<std::size_t>(
      std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                    [](const auto& entry) { return entry.path().extension() == ".label"; }));
}

void requireLabels(const fs::path& folder, std::size_t scans) {
  const std::size_t labels = countLabels(folder);
  if (labels == scans) return;
  throw IoError(std::to_string(labels) + " label files in " + folder.string() + " for " +
                std::to_string(scans) + " scans; are they of the same drive?");
}

std::vector<std::uint32_t> readFor(const fs::path& file, std::size_t points) {
  std::vector<std::uint32_t> labels = segdf::readLabels(file);
  if (labels.size() == points) return labels;
  throw IoError("label file " + file.string() + " has " + std::to_string(labels.size()) +
                " labels for a scan of " + std::to_string(points) +
                " points; is it of the same drive?");
}

IndexProtocol score(const Options& options) {
  segdf::KittiSource source(options.kitti);
  const fs::path truth = fs::path(options.kitti) / "labels";
  const fs::path estimate = options.labels;
  requireLabels(truth, source.size());
  requireLabels(estimate, source.size());
  IndexProtocol protocol(options.range);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const segdf::Scan scan = *source.next();
    std::ostringstream
        number;  // segdf numbers its label files from 0, whatever the scans are called
    number << std::setw(6) << std::setfill('0') << i << ".label";
    protocol.add(scan.points, readFor(truth / (source.nameOf(i) + ".label"), scan.points.size()),
                 readFor(estimate / number.str(), scan.points.size()));
  }
  if (protocol.scoredPoints() == 0) {
    throw IoError("no point of " + options.kitti +
                  " can be scored: all are of class 0 or 1 or beyond " +
                  segdf::formatNumber(options.range) + " m");
  }
  return protocol;
}

std::string percentText(const std::optional<double>& percent) {
  if (!percent) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << *percent;
  return text.str();
}

void print(const IndexProtocol& protocol) {
  const Share instances = protocol.instancesRemoved();
  std::cout << "by point index, " << protocol.scoredPoints() << " points scored\n"
            << "SA " << percentText(protocol.staticKept().percent()) << "  DA "
            << percentText(protocol.movingRemoved().percent()) << "  AA "
            << percentText(protocol.associatedAccuracy()) << "  HA "
            << percentText(protocol.harmonicAccuracy()) << '\n'
            << "parked SA " << percentText(protocol.parkedKept().percent()) << '\n'
            << "instances removed " << instances.part << " of " << instances.whole << '\n';
  for (std::size_t k = 0; k < kClassNames.size(); ++k) {
    const Share& share = protocol.movingByClass()[k];
    if (share.whole == 0) continue;
    std::cout << "DA " << kClassNames[k] << ' ' << percentText(share.percent()) << " ("
              << share.whole << " points)\n";
  }
}

Json toJson(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

void writeJson(const IndexProtocol& protocol, const fs::path& file) {
  Json json;
  json["protocol"] = "by point index";
  json["points"] = protocol.scoredPoints();
  json["SA"] = toJson(protocol.staticKept().percent());
  json["DA"] = toJson(protocol.movingRemoved().percent());
  json["AA"] = toJson(protocol.associatedAccuracy());
  json["HA"] = toJson(protocol.harmonicAccuracy());
  json["parked_SA"] = toJson(protocol.parkedKept().percent());
  json["instances_removed"] = protocol.instancesRemoved().part;
  json["instances"] = protocol.instancesRemoved().whole;
  for (std::size_t k = 0; k < kClassNames.size(); ++k) {
    json["DA_by_class"][kClassNames[k]] = toJson(protocol.movingByClass()[k].percent());
  }
  segdf::AtomicFile out(file);
  out.write(json.dump(2) + "\n");
  out.commit();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares the labels of a run with ground truth, point by point.", "segdf_evaluate");
  Options options;
  app.add_option("--kitti", options.kitti, "drive with velodyne/, labels/ and poses")->required();
  app.add_option("--labels", options.labels, "labels/ folder that segdf_offline wrote")->required();
  app.add_option("--range", options.range, "points within this distance are scored, m (default 50)")
      ->check(CLI::PositiveNumber);
  app.add_option("--json", options.json, "also write the figures here");
  return segdf::apps::runApp(app, argc, argv, [&options] {
    const IndexProtocol protocol = score(options);
    print(protocol);
    if (!options.json.empty()) writeJson(protocol, options.json);
    return static_cast<int>(segdf::apps::kOk);
  });
}

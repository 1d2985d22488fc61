// SPDX-License-Identifier: BSD-3-Clause
// Compares the labels of a run, or any map, with ground truth.
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "segdf/io/atomic_file.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/report/score_json.hpp"

#include "evaluate_drive.hpp"
#include "evaluate_protocols.hpp"
#include "evaluate_report.hpp"
#include "evaluate_text.hpp"
#include "run_app.hpp"
#include <nlohmann/json.hpp>

namespace {

using segdf::DriveScores;
using segdf::IoError;
using segdf::apps::LabelledDrive;
using segdf::apps::ProtocolChoice;
using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> kitti;
  std::vector<std::string> labels;
  std::vector<std::string> maps;
  std::vector<double> map_pose;
  std::string map_labels;
  std::string protocol;
  std::string frames;
  std::string json;
  std::string output;
  std::string report;
  std::string three_js = "/usr/share/javascript/three";
  ProtocolChoice choice;
};

void addOptions(CLI::App& app, Options& options) {
  app.add_option("--kitti", options.kitti,
                 "drive with velodyne/, labels/ and poses; several in one report")
      ->required();
  auto* scored = app.add_option_group("scored");
  scored->add_option("--labels", options.labels,
                     "labels/ folder that segdf_offline wrote, one for each drive");
  scored->add_option("--map", options.maps, "static map of any tool (PCD), one for each drive");
  scored->require_option(1);
  app.add_option("--protocol", options.protocol,
                 "index (default with --labels), draft, erasor, dynamicmap (default with --map) or "
                 "all (default with --report)")
      ->check(CLI::IsMember({"index", "draft", "erasor", "dynamicmap", "all"}));
  app.add_option("--frames", options.frames,
                 "only these scans of the drives, FIRST:LAST:STEP, ends inclusive");
  app.add_option("--range", options.choice.range,
                 "points within this distance are scored, m (default 50)")
      ->check(CLI::PositiveNumber);
  app.add_option("--spacing", options.choice.spacing,
                 "between the draft's scans, m (default 2; 0: every scan, for maps made of all)")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--map-pose", options.map_pose,
                 "X Y Z ROLL PITCH YAW of the map's frame in the truth's, m and deg")
      ->expected(6);
  app.add_option("--map-labels", options.map_labels,
                 "field of the map with truth labels for erasor (default: from the nearest truth)");
  app.add_flag("--judged-only", options.choice.judged_only,
               "erasor without points of class 0, which it else takes for static");
  app.add_option("--threads", options.choice.threads,
                 "worker threads (default 1); same figures with any")
      ->check(CLI::Range(1, 256));
  app.add_option("--json", options.json, "also write the figures here");
  app.add_option("--output", options.output,
                 "also write the draft's coloured map here, as PCD and PNG");
  app.add_option("--report", options.report, "also write report.html here, to be looked at");
  app.add_option(
      "--three-js", options.three_js,
      "folder with three.min.js, which the report holds (default: Debian's libjs-three)");
}

/// What the options say together. @throws IoError
void settle(Options& options) {
  const std::size_t scored = options.labels.size() + options.maps.size();
  if (scored != options.kitti.size()) {
    throw IoError(std::to_string(options.kitti.size()) + " drives (--kitti) but " +
                  std::to_string(scored) + " results (--labels or --map); give one for each");
  }
  const bool by_map = !options.maps.empty();
  if (options.protocol.empty()) {
    options.protocol = !options.report.empty() ? "all" : by_map ? "dynamicmap" : "index";
  }
  if (by_map && options.protocol == "index") {
    throw IoError("--protocol index needs --labels: the points of a map have no index in a scan");
  }
  const auto wants = [&options](const char* name) {
    return options.protocol == name || options.protocol == "all";
  };
  options.choice.index = !by_map && wants("index");
  options.choice.draft = wants("draft") || !options.output.empty();
  options.choice.erasor = wants("erasor");
  options.choice.map = wants("dynamicmap");
}

/// truth_T_map from x y z (m) roll pitch yaw (deg).
Eigen::Isometry3f mapPose(const std::vector<double>& numbers) {
  Eigen::Isometry3d truth_T_map = Eigen::Isometry3d::Identity();
  if (numbers.empty()) return truth_T_map.cast<float>();
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  truth_T_map.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  truth_T_map.linear() = (Eigen::AngleAxisd(numbers[5] * kRadians, Eigen::Vector3d::UnitZ()) *
                          Eigen::AngleAxisd(numbers[4] * kRadians, Eigen::Vector3d::UnitY()) *
                          Eigen::AngleAxisd(numbers[3] * kRadians, Eigen::Vector3d::UnitX()))
                             .toRotationMatrix();
  return truth_T_map.cast<float>();
}

segdf::MapCloud loadMap(const Options& options, std::size_t k) {
  segdf::MapCloud map = segdf::readMap(options.maps[k], options.map_labels);
  if (map.not_finite > 0) {
    std::cerr << "warning: " << map.not_finite << " points of " << options.maps[k]
              << " have NaN or infinite coordinates and are left out\n";
  }
  if (options.map_pose.empty()) return map;
  const Eigen::Isometry3f truth_T_map = mapPose(options.map_pose);
  for (Eigen::Vector3f& point : map.points) point = truth_T_map * point;
  return map;
}

/// One drive scored, printed and, for the report, drawn.
struct Scored {
  Json json;
  std::optional<segdf::ReportScene> scene;
};

Scored score(const Options& options, std::size_t k) {
  const segdf::FrameRange frames =
      options.frames.empty() ? segdf::FrameRange{} : segdf::parseFrameRange(options.frames);
  const bool by_map = !options.maps.empty();
  const LabelledDrive drive(options.kitti[k], by_map ? "" : options.labels[k], frames);
  std::optional<segdf::MapCloud> map;
  if (by_map) map = loadMap(options, k);
  const DriveScores scores = map ? segdf::apps::scoreMap(drive, *map, options.choice)
                                 : segdf::apps::scoreLabels(drive, options.choice);
  if (options.kitti.size() > 1) std::cout << "== " << scores.name << '\n';
  segdf::apps::printScores(std::cout, scores);
  if (!options.output.empty()) segdf::apps::writeDraftMap(options.output, scores);
  Scored scored{segdf::toJson(scores), std::nullopt};
  if (!options.report.empty()) scored.scene = segdf::apps::makeScene(drive, map, scores);
  return scored;
}

void writeJson(const Json& drives, const std::string& file) {
  segdf::writeWhole(
      file, (drives.size() == 1 ? drives.front() : Json{{"drives", drives}}).dump(2) + "\n");
}

int evaluate(Options& options) {
  settle(options);
  // Before any work: the report cannot be written without it.
  std::optional<segdf::ThreeJs> three;
  if (!options.report.empty()) three = segdf::readThreeJs(options.three_js);
  Json drives = Json::array();
  std::vector<segdf::ReportScene> scenes;
  for (std::size_t k = 0; k < options.kitti.size(); ++k) {
    Scored scored = score(options, k);
    drives.push_back(std::move(scored.json));
    if (scored.scene) scenes.push_back(std::move(*scored.scene));
  }
  if (three) {
    segdf::writeReport(options.report, scenes, *three);
    std::cout << "report in " << options.report << "/report.html\n";
  }
  if (!options.json.empty()) writeJson(drives, options.json);
  return segdf::apps::kOk;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares the labels of a run, or any static map, with ground truth.",
               "segdf_evaluate");
  Options options;
  addOptions(app, options);
  return segdf::apps::runApp(app, argc, argv, [&options] { return evaluate(options); });
}

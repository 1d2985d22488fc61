// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/report_page.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <system_error>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/class_names.hpp"
#include "segdf/io/atomic_file.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/report/base64.hpp"
#include "segdf/report/page_files.hpp"
#include "segdf/report/score_json.hpp"

#include <nlohmann/json.hpp>

namespace segdf {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 200;  // of a table that a person reads

std::string readText(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// No text may end the script element that it stands in.
std::string insideScript(std::string text) {
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3)) {
    text.insert(at + 1, "\\");
  }
  return text;
}

const PointScores* pointScores(const DriveScores& scores) {
  if (scores.index) return &*scores.index;
  return scores.map ? &*scores.map : nullptr;
}

Json instancesJson(const DriveScores& scores) {
  Json rows = Json::array();
  const PointScores* points = pointScores(scores);
  if (points == nullptr) return rows;
  for (const auto& [key, removed] : points->removedByInstance()) {
    if (removed.whole < PointScores::kMinInstancePoints) continue;
    rows.push_back({{"class", className(key.first)},
                    {"id", key.second},
                    {"moving", semantic_kitti::isMoving(key.first)},
                    {"points", removed.whole},
                    {"removed", removed.part}});
  }
  return rows;
}

Json evidenceJson(const ReportScene& scene) {
  const Evidence& evidence = scene.evidence;
  Json json{{"columns", evidence.columns}, {"total", evidence.removed.size()}};
  json["rows"] = Json::array();
  const auto id_column = std::find(evidence.columns.begin(), evidence.columns.end(), "id");
  for (std::size_t r = 0; r < std::min(kMostRows, evidence.removed.size()); ++r) {
    const std::vector<std::string>& cells = evidence.removed[r];
    const std::string& id = cells[static_cast<std::size_t>(id_column - evidence.columns.begin())];
    const auto truth = scene.truth_of_instance.find(
        static_cast<std::uint16_t>(std::strtoul(id.c_str(), nullptr, 10)));
    const bool known = id.size() <= 5 && truth != scene.truth_of_instance.end();
    json["rows"].push_back(
        {{"cells", cells},
         {"moving", known && truth->second.percent() ? Json(*truth->second.percent()) : Json()}});
  }
  return json;
}

Json cloudJson(const PackedCloud& cloud) {
  Json classes = Json::array();
  for (const std::uint16_t semantic_class : cloud.classes) {
    classes.push_back({{"id", semantic_class},
                       {"name", className(semantic_class)},
                       {"moving", semantic_kitti::isMoving(semantic_class)},
                       {"ground", semantic_kitti::isGround(semantic_class)}});
  }
  return {{"count", cloud.count},
          {"origin", {cloud.origin.x(), cloud.origin.y(), cloud.origin.z()}},
          {"step", cloud.step},
          {"voxel", cloud.voxel},
          {"classes", classes}};
}

Json sceneJson(const ReportScene& scene) {
  Json json{{"scores", toJson(scene.scores)},
            {"instances", instancesJson(scene.scores)},
            {"evidence", evidenceJson(scene)},
            {"cloud", cloudJson(scene.cloud)},
            {"trajectory", Json::array()}};
  for (const Eigen::Vector3d& p : scene.trajectory) {
    json["trajectory"].push_back({p.x(), p.y(), p.z()});
  }
  if (!scene.map_png.empty()) json["map"] = encodeBase64(scene.map_png);
  return json;
}

std::string data(const std::vector<ReportScene>& scenes) {
  Json json = Json::array();
  for (const ReportScene& scene : scenes) json.push_back(sceneJson(scene));
  // A folder's name may be no UTF-8.
  return insideScript(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string clouds(const std::vector<ReportScene>& scenes) {
  std::string elements;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    elements += "<script type=\"text/plain\" id=\"cloud-" + std::to_string(k) + "\">" +
                encodeBase64(scenes[k].cloud.bytes) + "</script>\n";
  }
  return elements;
}

/// Writes a template with each {{name}} replaced.
void fill(AtomicFile& out,
          const std::string& page,
          const std::map<std::string, std::function<std::string()>>& parts) {
  std::size_t from = 0;
  for (std::size_t at = page.find("{{"); at != std::string::npos; at = page.find("{{", from)) {
    out.write(page.substr(from, at - from));
    const std::size_t end = page.find("}}", at);
    out.write(parts.at(page.substr(at + 2, end - at - 2))());
    from = end + 2;
  }
  out.write(page.substr(from));
}

}  // namespace

ThreeJs readThreeJs(const fs::path& folder) {
  ThreeJs three;
  three.library = readText(folder / "three.min.js");
  three.orbit_controls = readText(folder / "examples/js/controls/OrbitControls.js");
  if (three.library.empty() || three.orbit_controls.empty()) {
    throw IoError("no three.js in " + folder.string() +
                  " (three.min.js and examples/js/controls/OrbitControls.js); install the package "
                  "libjs-three or give --three-js");
  }
  return three;
}

void writeReport(const fs::path& folder,
                 const std::vector<ReportScene>& scenes,
                 const ThreeJs& three) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw IoError("cannot write to report folder " + folder.string() + ": " + error.message());
  }
  AtomicFile out(folder / "report.html");
  fill(out, pageFiles().at("report.html"),
       {{"style", [] { return pageFiles().at("report.css"); }},
        {"three", [&three] { return three.library; }},
        {"controls", [&three] { return three.orbit_controls; }},
        {"data", [&scenes] { return data(scenes); }},
        {"clouds", [&scenes] { return clouds(scenes); }},
        {"charts", [] { return pageFiles().at("charts.js"); }},
        {"viewer", [] { return pageFiles().at("viewer.js"); }},
        {"report", [] { return pageFiles().at("report.js"); }}});
  out.commit();
}

}  // namespace segdf

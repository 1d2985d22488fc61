// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_text.hpp"

#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>

#include "segdf/core/config.hpp"
#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/class_names.hpp"

#include <nlohmann/json.hpp>

namespace segdf::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string fixed(const std::optional<double>& value, int digits) {
  if (!value) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << *value;
  return text.str();
}

std::string percentText(const std::optional<double>& percent) { return fixed(percent, 2); }

std::string bandName(std::size_t band) {
  const auto low = static_cast<double>(band) * PointScores::kBandWidth;
  if (band + 1 == PointScores::kBands) return "beyond " + formatNumber(low) + " m";
  return formatNumber(low) + "-" + formatNumber(low + PointScores::kBandWidth) + " m";
}

void printShare(std::ostream& out, const std::string& what, const Share& share) {
  if (share.whole == 0) return;
  out << what << ' ' << percentText(share.percent()) << " (" << share.whole << " points)\n";
}

void printBands(std::ostream& out, const std::string& what, const PointScores::ByBand& bands) {
  for (std::size_t k = 0; k < bands.size(); ++k) {
    printShare(out, what + " " + bandName(k), bands[k]);
  }
}

void printClasses(std::ostream& out, const PointScores& scores, bool moving) {
  for (const auto& [semantic_class, bands] : scores.rightByClass()) {
    if (semantic_kitti::isMoving(semantic_class) != moving) continue;
    printShare(out, (moving ? "DA " : "SA ") + className(semantic_class),
               scores.rightOfClass(semantic_class));
  }
}

void printHead(std::ostream& out, const PointScores& scores) {
  const Share instances = scores.instancesRemoved();
  out << "SA " << percentText(scores.staticKept().percent()) << "  DA "
      << percentText(scores.movingRemoved().percent()) << "  AA "
      << percentText(scores.associatedAccuracy()) << "  HA "
      << percentText(scores.harmonicAccuracy()) << '\n'
      << "parked SA " << percentText(scores.parkedKept().percent()) << '\n'
      << "instances removed " << instances.part << " of " << instances.whole << '\n';
}

void printDetails(std::ostream& out, const PointScores& scores) {
  const Share mistakes = scores.falseInstances();
  printClasses(out, scores, true);
  out << "ground SA " << percentText(scores.groundKept().percent()) << '\n'
      << "static instances removed " << mistakes.part << " of " << mistakes.whole << '\n';
  printClasses(out, scores, false);
  printBands(out, "SA at", scores.staticKeptByBand());
  printBands(out, "DA at", scores.movingRemovedByBand());
}

void printDraft(std::ostream& out, const DraftScores& draft, std::size_t scans, double spacing) {
  out << "draft's section IV, " << scans << " scans every " << formatNumber(spacing)
      << " m, 0.05 m voxels, 0.1 m co-appearance\n"
      << "TP " << draft.true_positive << "  FP " << draft.false_positive << "  TN "
      << draft.rejected_dynamic.part << "  FN " << draft.false_negative << '\n'
      << "precision " << percentText(draft.precision()) << "  recall "
      << percentText(draft.recall()) << "  F1 " << fixed(draft.f1(), 4) << "  dynamic rejected "
      << percentText(draft.rejected_dynamic.percent()) << '\n';
}

void printErasor(std::ostream& out, const VoxelScores& erasor) {
  out << "ERASOR, voxel-wise at 0.2 m, " << erasor.preserved.whole << " static and "
      << erasor.remaining_dynamic.whole << " dynamic voxels\n"
      << "PR " << percentText(erasor.preservationRate()) << "  RR "
      << percentText(erasor.rejectionRate()) << "  F1 " << fixed(erasor.f1(), 4) << '\n';
}

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json shareJson(const Share& share) {
  return {{"percent", number(share.percent())}, {"right", share.part}, {"points", share.whole}};
}

Json bandsJson(const PointScores::ByBand& bands) {
  Json json = Json::object();
  for (std::size_t k = 0; k < bands.size(); ++k) {
    if (bands[k].whole > 0) json[bandName(k)] = shareJson(bands[k]);
  }
  return json;
}

void addHead(Json& json, const PointScores& scores, const std::string& protocol) {
  json["protocol"] = protocol;
  json["points"] = scores.scoredPoints();
  json["SA"] = number(scores.staticKept().percent());
  json["DA"] = number(scores.movingRemoved().percent());
  json["AA"] = number(scores.associatedAccuracy());
  json["HA"] = number(scores.harmonicAccuracy());
  json["parked_SA"] = number(scores.parkedKept().percent());
  json["instances_removed"] = scores.instancesRemoved().part;
  json["instances"] = scores.instancesRemoved().whole;
}

void addPointScores(Json& json, const PointScores& scores, const std::string& protocol) {
  addHead(json, scores, protocol);
  json["ground_SA"] = number(scores.groundKept().percent());
  json["static_instances_removed"] = scores.falseInstances().part;
  json["static_instances"] = scores.falseInstances().whole;
  for (std::uint16_t c = semantic_kitti::kFirstMoving; c <= semantic_kitti::kLastMoving; ++c) {
    json["DA_by_class"][className(c)] = number(scores.rightOfClass(c).percent());
  }
  json["classes"] = Json::array();
  for (const auto& [semantic_class, bands] : scores.rightByClass()) {
    Json row{{"class", semantic_class},
             {"name", className(semantic_class)},
             {"moving", semantic_kitti::isMoving(semantic_class)}};
    row.update(shareJson(scores.rightOfClass(semantic_class)));
    row["by_range"] = bandsJson(bands);
    json["classes"].push_back(row);
  }
  json["SA_by_range"] = bandsJson(scores.staticKeptByBand());
  json["DA_by_range"] = bandsJson(scores.movingRemovedByBand());
}

Json draftJson(const DriveScores& scores, double spacing) {
  const DraftScores& draft = *scores.draft;
  return {{"protocol", "draft's section IV"},
          {"spacing_m", spacing},
          {"scans", scores.draft_scans},
          {"TP", draft.true_positive},
          {"FP", draft.false_positive},
          {"TN", draft.rejected_dynamic.part},
          {"FN", draft.false_negative},
          {"dynamic", draft.rejected_dynamic.whole},
          {"precision", number(draft.precision())},
          {"recall", number(draft.recall())},
          {"F1", number(draft.f1())},
          {"dynamic_rejected", number(draft.rejected_dynamic.percent())}};
}

Json erasorJson(const VoxelScores& erasor) {
  return {{"protocol", "ERASOR, voxel-wise at 0.2 m"},
          {"PR", number(erasor.preservationRate())},
          {"RR", number(erasor.rejectionRate())},
          {"F1", number(erasor.f1())},
          {"static_voxels", erasor.preserved.whole},
          {"dynamic_voxels", erasor.remaining_dynamic.whole}};
}

}  // namespace

void printScores(std::ostream& out, const DriveScores& scores, const ProtocolChoice& choice) {
  if (scores.index) {
    out << "by point index, " << scores.index->scoredPoints() << " points scored\n";
    printHead(out, *scores.index);
    printDetails(out, *scores.index);
  }
  if (scores.draft) printDraft(out, *scores.draft, scores.draft_scans, choice.spacing);
  if (scores.erasor) printErasor(out, *scores.erasor);
  if (!scores.map) return;
  out << "DynamicMap, nearest map point within 0.05 m, " << scores.map->scoredPoints()
      << " points scored\n";
  printHead(out, *scores.map);
  if (!scores.index) printDetails(out, *scores.map);
}

nlohmann::ordered_json toJson(const DriveScores& scores, const ProtocolChoice& choice) {
  Json json;
  if (scores.index) addPointScores(json, *scores.index, "by point index");
  json["drive"] = scores.name;
  json["scans"] = scores.scans;
  json["range_m"] = choice.range;
  if (scores.draft) json["draft"] = draftJson(scores, choice.spacing);
  if (scores.erasor) json["erasor"] = erasorJson(*scores.erasor);
  if (scores.map) addPointScores(json["dynamicmap"], *scores.map, "DynamicMap, 0.05 m");
  return json;
}

}  // namespace segdf::apps

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/score_json.hpp"

#include <optional>
#include <string>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/class_names.hpp"

#include <nlohmann/json.hpp>

namespace segdf {

namespace {

using Json = nlohmann::ordered_json;

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

Json draftJson(const DriveScores& scores) {
  const DraftScores& draft = *scores.draft;
  return {{"protocol", "draft's section IV"},
          {"spacing_m", scores.draft_spacing},
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

Json erasorJson(const VoxelScores& erasor, bool judged_only) {
  return {{"protocol", "ERASOR, voxel-wise at 0.2 m"},
          {"judged_only", judged_only},
          {"PR", number(erasor.preservationRate())},
          {"RR", number(erasor.rejectionRate())},
          {"F1", number(erasor.f1())},
          {"static_voxels", erasor.preserved.whole},
          {"dynamic_voxels", erasor.remaining_dynamic.whole}};
}

}  // namespace

nlohmann::ordered_json toJson(const DriveScores& scores) {
  Json json;
  if (scores.index) addPointScores(json, *scores.index, "by point index");
  json["drive"] = scores.name;
  json["scans"] = scores.scans;
  json["range_m"] = scores.range;
  if (scores.draft) json["draft"] = draftJson(scores);
  if (scores.erasor) json["erasor"] = erasorJson(*scores.erasor, scores.judged_only);
  if (scores.map) addPointScores(json["dynamicmap"], *scores.map, "DynamicMap, 0.05 m");
  return json;
}

}  // namespace segdf

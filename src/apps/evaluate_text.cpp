// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_text.hpp"

#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>

#include "segdf/core/config.hpp"
#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/class_names.hpp"

namespace segdf::apps {

namespace {

std::string fixed(const std::optional<double>& value, int digits) {
  if (!value) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << *value;
  return text.str();
}

std::string percentText(const std::optional<double>& percent) { return fixed(percent, 2); }

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

void printDraft(std::ostream& out, const DriveScores& scores) {
  const DraftScores& draft = *scores.draft;
  out << "draft's section IV, " << scores.draft_scans << " scans every "
      << formatNumber(scores.draft_spacing) << " m, 0.05 m voxels, 0.1 m co-appearance\n"
      << "TP " << draft.true_positive << "  FP " << draft.false_positive << "  TN "
      << draft.rejected_dynamic.part << "  FN " << draft.false_negative << '\n'
      << "precision " << percentText(draft.precision()) << "  recall "
      << percentText(draft.recall()) << "  F1 " << fixed(draft.f1(), 4) << "  dynamic rejected "
      << percentText(draft.rejected_dynamic.percent()) << '\n';
}

void printErasor(std::ostream& out, const VoxelScores& erasor, bool judged_only) {
  out << "ERASOR, voxel-wise at 0.2 m, " << (judged_only ? "judged points only, " : "")
      << erasor.preserved.whole << " static and " << erasor.remaining_dynamic.whole
      << " dynamic voxels\n"
      << "PR " << percentText(erasor.preservationRate()) << "  RR "
      << percentText(erasor.rejectionRate()) << "  F1 " << fixed(erasor.f1(), 4) << '\n';
}

}  // namespace

void printScores(std::ostream& out, const DriveScores& scores) {
  if (scores.index) {
    out << "by point index, " << scores.index->scoredPoints() << " points scored\n";
    printHead(out, *scores.index);
    printDetails(out, *scores.index);
  }
  if (scores.draft) printDraft(out, scores);
  if (scores.erasor) printErasor(out, *scores.erasor, scores.judged_only);
  if (!scores.map) return;
  out << "DynamicMap, nearest map point within 0.05 m, " << scores.map->scoredPoints()
      << " points scored\n";
  printHead(out, *scores.map);
  if (!scores.index) printDetails(out, *scores.map);
}

}  // namespace segdf::apps

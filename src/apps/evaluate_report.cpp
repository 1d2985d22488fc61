// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <system_error>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/index_protocol.hpp"
#include "segdf/evaluation/map_protocol.hpp"
#include "segdf/evaluation/point_grid.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/report/verdict_image.hpp"

namespace segdf::apps {

namespace {

constexpr double kTolerance = 0.05;  // metres: as in the DynamicMap benchmark

/// Tells whether point i of a scan, at a place in the map frame, is in the estimated map.
using IsKept =
    std::function<bool(const LabelledScan&, std::size_t i, const Eigen::Vector3f& place)>;

IsKept keptBy(const std::optional<MapCloud>& map) {
  if (!map) {
    return [](const LabelledScan& labelled, std::size_t i, const Eigen::Vector3f& /*place*/) {
      return isKeptLabel(labelled.estimate[i]);
    };
  }
  const auto grid = std::make_shared<PointGrid>(map->points, 2.0 * kTolerance);
  return [grid](const LabelledScan& /*labelled*/, std::size_t /*i*/, const Eigen::Vector3f& place) {
    return grid->hasWithin(place, kTolerance);
  };
}

PointFate fateOf(std::uint16_t semantic_class, bool kept) {
  if (semantic_kitti::isIgnored(semantic_class)) return PointFate::kNotScored;
  if (semantic_kitti::isMoving(semantic_class)) {
    return kept ? PointFate::kKeptMoving : PointFate::kRemovedMoving;
  }
  return kept ? PointFate::kKeptStatic : PointFate::kRemovedStatic;
}

/// Intensities come as 0..1 or 0..255.
std::uint8_t byteOf(float intensity) {
  const float scaled = intensity <= 1.0F ? 255.0F * intensity : intensity;
  return static_cast<std::uint8_t>(std::lround(std::clamp(scaled, 0.0F, 255.0F)));
}

/// Adds one scan to the view and to the truth of the run's instances.
void addScan(const LabelledScan& labelled,
             double range,
             const IsKept& is_kept,
             ViewCloud& cloud,
             ReportScene& scene) {
  for (std::size_t i = 0; i < labelled.truth.size(); ++i) {
    const Point& point = labelled.scan.points[i];
    if (!(point.position().norm() <= static_cast<float>(range))) continue;
    ViewPoint seen;
    seen.position = inMapFrame(labelled.scan.pose, point);
    seen.semantic_class = semantic_kitti::classOf(labelled.truth[i]);
    const bool has_labels = !labelled.estimate.empty();
    seen.instance =
        semantic_kitti::instanceOf(has_labels ? labelled.estimate[i] : labelled.truth[i]);
    seen.intensity = byteOf(std::isfinite(point.intensity) ? point.intensity : 0.0F);
    seen.fate = fateOf(seen.semantic_class, is_kept(labelled, i, seen.position));
    cloud.add(seen);
    if (has_labels && seen.instance != 0 && seen.fate != PointFate::kNotScored) {
      scene.truth_of_instance[seen.instance].count(semantic_kitti::isMoving(seen.semantic_class));
    }
  }
}

}  // namespace

ReportScene makeScene(const LabelledDrive& drive,
                      const std::optional<MapCloud>& map,
                      const DriveScores& scores) {
  ReportScene scene;
  scene.scores = scores;
  if (scene.scores.draft) {
    scene.map_png = encodePng(drawVerdicts(*scene.scores.draft));
    scene.scores.draft->points = {};  // drawn: the page needs the figures only
    scene.scores.draft->verdicts = {};
  }
  const IsKept is_kept = keptBy(map);
  ViewCloud cloud;
  drive.forEach([&](const LabelledScan& labelled) {
    scene.trajectory.emplace_back(labelled.scan.pose.translation());
    addScan(labelled, scores.range, is_kept, cloud, scene);
  });
  scene.cloud = cloud.finish();
  const std::filesystem::path evidence = drive.labels().parent_path() / "instances.csv";
  if (!map && std::filesystem::exists(evidence)) scene.evidence = readEvidence(evidence);
  return scene;
}

void writeDraftMap(const std::filesystem::path& folder, const DriveScores& scores) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw IoError("cannot write to output folder " + folder.string() + ": " + error.message());
  }
  std::vector<ColouredPoint> points;
  points.reserve(scores.draft->points.size());
  for (std::size_t i = 0; i < scores.draft->points.size(); ++i) {
    const MapVerdict verdict = scores.draft->verdicts[i];
    const VerdictColour colour = colourOf(verdict);
    points.push_back({scores.draft->points[i], colour.red, colour.green, colour.blue,
                      static_cast<std::uint32_t>(verdict)});
  }
  writeColouredMap(folder / (scores.name + "_map.pcd"), points);
  writePng(folder / (scores.name + "_map.png"), drawVerdicts(*scores.draft));
}

}  // namespace segdf::apps

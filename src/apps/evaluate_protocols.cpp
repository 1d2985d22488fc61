// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate_protocols.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "segdf/core/config.hpp"
#include "segdf/core/parallel.hpp"
#include "segdf/core/semantic_kitti.hpp"
#include "segdf/evaluation/index_protocol.hpp"
#include "segdf/evaluation/map_overlap.hpp"
#include "segdf/evaluation/map_protocol.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf::apps {

namespace {

// Points of the truth by which the frame of a map is checked.
constexpr std::size_t kProbes = 4000;
constexpr double kProbeRange = 30.0;     // metres: nearer points are denser in any map
constexpr double kLeastOverlap = 0.1;    // no map worth scoring has lost nine points in ten
constexpr double kRaiseThatTells = 0.2;  // chance alone never gains as much

void requireScored(const PointScores& scores, const LabelledDrive& drive, double range) {
  if (scores.scoredPoints() > 0) return;
  throw IoError("no point of " + drive.folder().string() +
                " can be scored: all are of class 0 or 1 or beyond " + formatNumber(range) + " m");
}

PointScores scoreByIndex(const LabelledDrive& drive, double range) {
  IndexProtocol protocol(range);
  drive.forEach([&protocol](const LabelledScan& labelled) {
    protocol.add(labelled.scan.points, labelled.truth, labelled.estimate);
  });
  requireScored(protocol.scores(), drive, range);
  return protocol.scores();
}

DraftProtocol collectDraft(const LabelledDrive& drive,
                           const ProtocolChoice& choice,
                           std::size_t& scans) {
  DraftProtocol protocol(choice.range, choice.threads);
  SpacedScans spaced(choice.spacing);
  scans = 0;
  drive.forEach([&](const LabelledScan& labelled) {
    if (!spaced.pick(labelled.scan.pose)) return;
    ++scans;
    protocol.add(labelled.scan, labelled.truth, labelled.estimate);
  });
  return protocol;
}

PointScores scoreByMap(const LabelledDrive& drive,
                       const std::vector<Eigen::Vector3f>& map,
                       const ProtocolChoice& choice) {
  MapProtocol protocol(map, choice.range, choice.threads);
  drive.forEach(
      [&protocol](const LabelledScan& labelled) { protocol.add(labelled.scan, labelled.truth); });
  requireScored(protocol.scores(), drive, choice.range);
  return protocol.scores();
}

/// The map that the labels stand for: all points that they keep.
std::vector<Eigen::Vector3f> keptPoints(const LabelledDrive& drive) {
  std::vector<Eigen::Vector3f> kept;
  drive.forEach([&kept](const LabelledScan& labelled) {
    for (std::size_t i = 0; i < labelled.estimate.size(); ++i) {
      const Point& point = labelled.scan.points[i];
      if (!isKeptLabel(labelled.estimate[i]) || !isFinite(point)) continue;
      kept.push_back(inMapFrame(labelled.scan.pose, point));
    }
  });
  return kept;
}

bool isJudged(std::uint32_t truth) {
  return semantic_kitti::classOf(truth) != semantic_kitti::kUnlabelled;
}

/// Points of a scan that take part in ERASOR's maps, in the map frame; with labels to be scored
/// only those that they keep if `kept_only`.
ClassedPoints erasorPoints(const LabelledScan& labelled, bool kept_only, bool judged_only) {
  ClassedPoints points;
  for (std::size_t i = 0; i < labelled.truth.size(); ++i) {
    const Point& point = labelled.scan.points[i];
    if (!VoxelMapBuilder::takes(point.position())) continue;
    if (kept_only && !isKeptLabel(labelled.estimate[i])) continue;
    if (judged_only && !isJudged(labelled.truth[i])) continue;
    points.add(inMapFrame(labelled.scan.pose, point), semantic_kitti::classOf(labelled.truth[i]));
  }
  return points;
}

VoxelScores scoreErasor(const LabelledDrive& drive, const ProtocolChoice& choice) {
  std::array<VoxelMapBuilder, 2> maps;  // of the truth, and of the points that are kept
  drive.forEach([&](const LabelledScan& labelled) {
    parallelFor(maps.size(), choice.threads, [&](std::size_t k) {
      maps[k].add(erasorPoints(labelled, k == 1, choice.judged_only));
    });
  });
  return compareVoxelMaps(maps[0].finish(), maps[1].finish());
}

ClassedPoints allTruth(const LabelledDrive& drive) {
  ClassedPoints truth;
  drive.forEach([&truth](const LabelledScan& labelled) {
    for (std::size_t i = 0; i < labelled.truth.size(); ++i) {
      const Point& point = labelled.scan.points[i];
      if (!isFinite(point)) continue;
      truth.add(inMapFrame(labelled.scan.pose, point), semantic_kitti::classOf(labelled.truth[i]));
    }
  });
  return truth;
}

ClassedPoints classedMap(const LabelledDrive& drive, const MapCloud& map, int threads) {
  if (map.labels.empty()) return transferClasses(allTruth(drive), map.points, threads);
  ClassedPoints classed;
  classed.points = map.points;
  classed.classes.reserve(map.labels.size());
  for (const std::uint32_t label : map.labels) {
    classed.classes.push_back(semantic_kitti::classOf(label));
  }
  return classed;
}

ClassedPoints judgedPoints(const ClassedPoints& all) {
  ClassedPoints judged;
  for (std::size_t i = 0; i < all.points.size(); ++i) {
    if (isJudged(all.classes[i])) judged.add(all.points[i], all.classes[i]);
  }
  return judged;
}

VoxelScores scoreErasorMap(const LabelledDrive& drive,
                           const MapCloud& map,
                           const ProtocolChoice& choice) {
  ClassedPoints classed = classedMap(drive, map, choice.threads);
  if (choice.judged_only) classed = judgedPoints(classed);
  const ClassedPoints estimate = voxelFilter(classed, VoxelMapBuilder::kLeaf);
  VoxelMapBuilder truth;
  drive.forEach([&](const LabelledScan& labelled) {
    truth.add(erasorPoints(labelled, false, choice.judged_only));
  });
  return compareVoxelMaps(truth.finish(), estimate);
}

/// Static points of the truth, spread evenly over the drive.
std::vector<Eigen::Vector3f> probes(const LabelledDrive& drive) {
  std::vector<Eigen::Vector3f> result;
  const std::size_t each = kProbes / drive.size() + 1;
  drive.forEach([&](const LabelledScan& labelled) {
    const std::size_t step = std::max<std::size_t>(1, labelled.truth.size() / each);
    for (std::size_t i = 0; i < labelled.truth.size(); i += step) {
      const std::uint16_t semantic_class = semantic_kitti::classOf(labelled.truth[i]);
      const Point& point = labelled.scan.points[i];
      if (semantic_kitti::isIgnored(semantic_class) || semantic_kitti::isMoving(semantic_class) ||
          !(point.position().norm() <= static_cast<float>(kProbeRange))) {
        continue;
      }
      result.push_back(inMapFrame(labelled.scan.pose, point));
    }
  });
  return result;
}

void requireOverlap(const LabelledDrive& drive, const std::vector<Eigen::Vector3f>& map) {
  const std::vector<Eigen::Vector3f> truth = probes(drive);
  if (truth.empty()) return;  // the protocols say that nothing can be scored
  const MapOverlap overlap = measureOverlap(truth, map);
  const auto percent = [](double share) { return formatNumber(std::round(100.0 * share)) + " %"; };
  const std::string found = "the map does not lie on the truth: only " + percent(overlap.share) +
                            " of the static points have a map point within 0.25 m";
  if (overlap.raised_share > overlap.share + kRaiseThatTells) {
    const std::string raise = formatNumber(std::round(10.0 * overlap.raise) / 10.0);
    throw IoError(found + ", but " + percent(overlap.raised_share) + " with the map raised by " +
                  raise + " m; try --map-pose 0 0 " + raise + " 0 0 0");
  }
  if (overlap.share < kLeastOverlap) {
    throw IoError(found + "; is it of this drive? If it is in another frame, give --map-pose");
  }
}

DriveScores blankScores(const LabelledDrive& drive, const ProtocolChoice& choice) {
  DriveScores scores;
  scores.name = drive.name();
  scores.scans = drive.size();
  scores.range = choice.range;
  scores.draft_spacing = choice.spacing;
  scores.judged_only = choice.judged_only;
  return scores;
}

}  // namespace

DriveScores scoreLabels(const LabelledDrive& drive, const ProtocolChoice& choice) {
  DriveScores scores = blankScores(drive, choice);
  if (choice.index) scores.index = scoreByIndex(drive, choice.range);
  if (choice.draft) scores.draft = collectDraft(drive, choice, scores.draft_scans).score();
  if (choice.erasor) scores.erasor = scoreErasor(drive, choice);
  if (choice.map) scores.map = scoreByMap(drive, keptPoints(drive), choice);
  return scores;
}

DriveScores scoreMap(const LabelledDrive& drive,
                     const MapCloud& map,
                     const ProtocolChoice& choice) {
  requireOverlap(drive, map.points);
  DriveScores scores = blankScores(drive, choice);
  if (choice.draft) {
    scores.draft = collectDraft(drive, choice, scores.draft_scans).score(map.points);
  }
  if (choice.erasor) scores.erasor = scoreErasorMap(drive, map, choice);
  if (choice.map) scores.map = scoreByMap(drive, map.points, choice);
  return scores;
}

}  // namespace segdf::apps

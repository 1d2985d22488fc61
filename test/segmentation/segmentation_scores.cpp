// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation_scores.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "segdf/core/semantic_kitti.hpp"

namespace segdf::test {

namespace {

using semantic_kitti::classOf;
using semantic_kitti::instanceOf;
using semantic_kitti::isIgnored;
using semantic_kitti::isMoving;

constexpr std::size_t kMinInstancePoints = 30;

bool isGroundTruth(std::uint16_t c) {
  constexpr std::array<std::uint16_t, 6> kGround{40, 44, 48, 49, 60, 72};
  return std::find(kGround.begin(), kGround.end(), c) != kGround.end();
}

ClassScore::Truth kindOf(std::uint16_t c) {
  if (isMovable(c)) return ClassScore::kMovable;
  if (c == 50) return ClassScore::kBuilding;
  if (c == 70) return ClassScore::kVegetation;
  if (c == 71 || c == 80 || c == 81) return ClassScore::kPole;
  return isGroundTruth(c) ? ClassScore::kGroundTruth : ClassScore::kOther;
}

ClassScore::Answer answerOf(ObjectClass c) {
  switch (c) {
    case ObjectClass::kVegetation:
      return ClassScore::kVeg;
    case ObjectClass::kBuilding:
      return ClassScore::kBuild;
    case ObjectClass::kHighMobility:
      return ClassScore::kHighMobility;
    case ObjectClass::kUnknown:
    case ObjectClass::kNone:
      break;
  }
  return ClassScore::kUnknown;
}

}  // namespace

bool isMovable(std::uint16_t c) { return (c >= 10 && c <= 32) || isMoving(c); }

void GroundScore::add(const std::vector<PointRole>& roles,
                      const std::vector<std::uint32_t>& truth) {
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const std::uint16_t c = classOf(truth[i]);
    if (roles[i] == PointRole::kUnused || isIgnored(c)) continue;
    const bool marked = roles[i] == PointRole::kGround;
    if (isMovable(c) && instanceOf(truth[i]) != 0) movable.add(marked);
    if (isMoving(c)) moving.add(marked);
    if (c == 70) continue;
    const bool is_ground = isGroundTruth(c);
    if (marked) precision.add(is_ground);
    if (is_ground) recall.add(marked);
  }
}

double GroundScore::f1() const {
  const double p = precision.percent();
  const double r = recall.percent();
  return p + r > 0.0 ? 2.0 * p * r / (p + r) : 0.0;
}

void InstanceScore::add(const std::vector<std::int32_t>& of_point,
                        const std::vector<PointRole>& roles,
                        const std::vector<std::uint32_t>& truth) {
  std::map<std::int32_t, double> cluster_size;
  std::map<std::uint32_t, double> instance_size;
  std::map<std::uint32_t, std::map<std::int32_t, double>> shared;
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    const std::uint16_t c = classOf(truth[i]);
    if (roles[i] == PointRole::kUnused || isIgnored(c)) continue;
    if (of_point[i] >= 0) cluster_size[of_point[i]] += 1.0;
    if (!isMovable(c) || instanceOf(truth[i]) == 0) continue;
    instance_size[truth[i]] += 1.0;
    if (of_point[i] >= 0) shared[truth[i]][of_point[i]] += 1.0;
  }
  ++scans;
  clusters += cluster_size.size();
  for (const auto& [instance, size] : instance_size) {
    if (size < static_cast<double>(kMinInstancePoints)) continue;
    ++instances;
    double best = 0.0;
    double best_coverage = 0.0;
    double best_purity = 0.0;
    for (const auto& [cluster, points] : shared[instance]) {
      const double value = points / (size + cluster_size[cluster] - points);
      if (value <= best) continue;
      best = value;
      best_coverage = points / size;
      best_purity = points / cluster_size[cluster];
    }
    iou += best;
    coverage += best_coverage;
    purity += best_purity;
    if (best > 0.5) ++found;
  }
}

void ClassScore::add(const Segmentation& seg, const std::vector<std::uint32_t>& truth) {
  std::vector<Answer> answers(truth.size(), kNoise);
  for (const Segment& segment : seg.segments) {
    for (std::uint32_t i : segment.points) answers[i] = answerOf(segment.object_class);
  }
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint16_t c = classOf(truth[i]);
    if (seg.roles[i] == PointRole::kUnused || isIgnored(c)) continue;
    const Answer answer = seg.roles[i] == PointRole::kGround ? kGround : answers[i];
    points[kindOf(c)][answer] += 1.0;
  }
}

double ClassScore::total(Truth truth) const {
  double sum = 0.0;
  for (double n : points[truth]) sum += n;
  return sum;
}

double ClassScore::excludedOfSegmented(Truth truth) const {
  const auto& row = points[truth];
  const double segmented = total(truth) - row[kGround] - row[kNoise];
  return segmented > 0.0 ? 100.0 * (row[kVeg] + row[kBuild]) / segmented : 0.0;
}

double ClassScore::excludedOfAll(Truth truth) const {
  const auto& row = points[truth];
  const double all = total(truth);
  return all > 0.0 ? 100.0 * (row[kVeg] + row[kBuild] + row[kGround]) / all : 0.0;
}

}  // namespace segdf::test

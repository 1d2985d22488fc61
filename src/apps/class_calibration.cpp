// SPDX-License-Identifier: BSD-3-Clause
#include "class_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "segdf/classification/classifier.hpp"
#include "segdf/core/semantic_kitti.hpp"

namespace segdf::apps {

namespace {

constexpr double kKept = 99.0;          // percent of movable points
constexpr std::size_t kMinPoints = 20;  // of a segment in the table
constexpr double kMajority = 0.7;       // of one truth
constexpr int kRounds = 3;
constexpr double kDigits = 1000.0;
constexpr std::array<double, 6> kFactors{0.6, 0.8, 0.9, 1.1, 1.25, 1.6};
constexpr std::array<double, 5> kBands{0.0, 10.0, 20.0, 35.0, 50.0};  // m
constexpr std::array<double, 5> kShares{0.05, 0.25, 0.5, 0.75, 0.95};
constexpr std::array<const char*, 4> kTruthNames{"movable", "building", "vegetation", "other"};

constexpr std::array<const char*, static_cast<std::size_t>(Feature::kCount)> kFeatureNames{
    "linearity",
    "planarity",
    "scattering",
    "omnivariance",
    "anisotropy",
    "eigenentropy",
    "curvature_change",
    "eigenvalue_sum",
    "verticality",
    "main_axis_z",
    "eigenvalue_sum_2d",
    "eigenvalue_ratio_2d",
    "moment_first_axis",
    "moment_second_axis",
    "local_curvature",
    "vertical_share",
    "smooth_share",
    "bottom",
    "top",
    "height",
    "length",
    "width",
    "elongation",
    "footprint",
    "volume",
    "range",
    "log_count",
    "density",
    "topcut",
    "ground_contact",
    "roughness"};

Truth truthOf(std::uint16_t c) {
  if ((c >= 10 && c <= 32) || semantic_kitti::isMoving(c)) return Truth::kMovable;
  if (c == 50 || c == 51 || c == 52) return Truth::kBuilding;
  return c == 70 || c == 71 ? Truth::kVegetation : Truth::kOther;
}

/// The thresholds of a ClassConfig with their bounds.
struct Threshold {
  double* value;
  double min;
  double max;
};

class ThresholdVisitor {
 public:
  void number(const char*, double& value, double min, double max, const char*, const char*) {
    thresholds.push_back({&value, min, max});
  }
  std::vector<Threshold> thresholds;
};

bool isBetter(const ClassCalibration::Score& a, const ClassCalibration::Score& b) {
  const bool safe = a.movable_kept >= std::min(kKept, b.movable_kept);
  const bool saves = b.movable_kept < kKept && a.movable_kept > b.movable_kept;
  return saves || (safe && a.excluded > b.excluded);
}

}  // namespace

void ClassCalibration::add(const Segmentation& seg, const std::vector<std::uint32_t>& truth) {
  for (const Segment& segment : seg.segments) {
    Sample sample;
    sample.features = segment.features;
    sample.points = segment.points.size();
    for (std::uint32_t i : segment.points) {
      const std::uint16_t c = semantic_kitti::classOf(truth[i]);
      if (semantic_kitti::isIgnored(c)) continue;
      sample.truth[static_cast<std::size_t>(truthOf(c))] += 1.0;
    }
    samples_.push_back(sample);
  }
}

ClassCalibration::Score ClassCalibration::score(const ClassConfig& config) const {
  double movable = 0.0;
  double movable_kept = 0.0;
  double fixed = 0.0;
  double fixed_excluded = 0.0;
  for (const Sample& s : samples_) {
    const bool tested = isTested(classify(s.features, s.points, config));
    const double still = s.truth[static_cast<std::size_t>(Truth::kBuilding)] +
                         s.truth[static_cast<std::size_t>(Truth::kVegetation)];
    movable += s.truth[static_cast<std::size_t>(Truth::kMovable)];
    fixed += still;
    if (tested) movable_kept += s.truth[static_cast<std::size_t>(Truth::kMovable)];
    if (!tested) fixed_excluded += still;
  }
  return {movable > 0.0 ? 100.0 * movable_kept / movable : 100.0,
          fixed > 0.0 ? 100.0 * fixed_excluded / fixed : 0.0};
}

/// Values of a feature over the segments of one truth in one range band, ascending.
std::vector<float> ClassCalibration::valuesOf(std::size_t feature,
                                              std::size_t truth,
                                              std::size_t band) const {
  std::vector<float> values;
  for (const Sample& s : samples_) {
    const auto range = static_cast<double>(s.features[Feature::kRange]);
    const bool clear = s.truth[truth] >= kMajority * static_cast<double>(s.points);
    const bool inside = range >= kBands[band] && range < kBands[band + 1];
    if (s.points >= kMinPoints && clear && inside) values.push_back(s.features.values[feature]);
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::string ClassCalibration::quantiles() const {
  std::ostringstream text;
  text << std::setprecision(4)
       << "feature truth range_from_m range_to_m segments q05 q25 q50 q75 q95\n";
  for (std::size_t f = 0; f < kFeatureNames.size(); ++f) {
    for (std::size_t t = 0; t < kTruthNames.size(); ++t) {
      for (std::size_t band = 0; band + 1 < kBands.size(); ++band) {
        const std::vector<float> values = valuesOf(f, t, band);
        if (values.empty()) continue;
        text << kFeatureNames[f] << ' ' << kTruthNames[t] << ' ' << kBands[band] << ' '
             << kBands[band + 1] << ' ' << values.size();
        for (double share : kShares) {
          const auto k = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
          text << ' ' << values[k];
        }
        text << '\n';
      }
    }
  }
  return text.str();
}

ClassConfig ClassCalibration::propose(const ClassConfig& start) const {
  ClassConfig best = start;
  Score best_score = score(best);
  for (int round = 0; round < kRounds; ++round) {
    ClassConfig tried = best;
    ThresholdVisitor visitor;
    ClassConfig::visit(tried, visitor);
    for (const Threshold& threshold : visitor.thresholds) {
      for (double factor : kFactors) {
        const double old = *threshold.value;
        const double tried_value = std::round(old * factor * kDigits) / kDigits;
        *threshold.value = std::clamp(tried_value, threshold.min, threshold.max);
        const Score result = score(tried);
        if (isBetter(result, best_score)) {
          best = tried;
          best_score = result;
        } else {
          *threshold.value = old;
        }
      }
    }
  }
  return best;
}

}  // namespace segdf::apps

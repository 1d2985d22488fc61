// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/intensity_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Dense>

#include "segdf/core/quantile.hpp"
#include "segdf/segmentation/intensity.hpp"

namespace segdf {

namespace {

constexpr float kSmooth = 0.02F;        // greatest change of curvature of a smooth neighbourhood
constexpr double kLeastCosine = 0.15;   // normals at a more grazing angle are too uncertain
constexpr double kRangeStep = 0.1;      // of log R: cells of 10 % in range ...
constexpr double kCosineStep = 0.1;     // ... and this in the cosine
constexpr std::size_t kCellPoints = 5;  // fewer say little of their mean
constexpr std::size_t kMinSurfaces = 20;
// Least mean square spread of log R and log cos within surfaces that determines exponents.
constexpr double kLeastSpread = 1e-4;
constexpr double kBinPoints = 50.0;  // a bin with fewer is not shown
// Half the distance between the exponents of a compensated sensor, (0, 0), and of formula (6),
// (2, 1), is 1.1: farther from both than this is neither.
constexpr double kFarthest = 0.9;
constexpr double kErrors = 2.0;       // standard errors
constexpr double kFull = 0.99;        // quantile taken for full scale: above are reflectors
constexpr double kScaleFactor = 2.0;  // a profile's scale is kept within this factor
constexpr double kDiffuseShare = 0.95;
constexpr double kUnit = 1.0;

double distanceTo(const IntensityFit& fit, const IntensityModel& model) {
  return std::hypot(fit.range_exponent - model.range_exponent,
                    fit.incidence_exponent - model.incidence_exponent);
}

double toThreeDigits(double value) {
  if (!(value > 0.0)) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::round(value / unit) * unit;
}

/// Bins of a quantity x, with the geometric mean of what is relative to the surface's own.
class Bins {
 public:
  explicit Bins(double step) : step_(step) {}

  void add(double x, double log_relative, double weight) {
    Bin& bin = bins_[static_cast<int>(std::floor(x / step_))];
    bin.weight += weight;
    bin.sum += weight * log_relative;
  }

  /// @param border takes a border of x to what is shown
  template <class Border>
  std::vector<IntensityBin> list(const Border& border) const {
    std::vector<IntensityBin> result;
    for (const auto& [k, bin] : bins_) {
      if (bin.weight < kBinPoints) continue;
      result.push_back({border(k * step_), border((k + 1) * step_),
                        static_cast<std::size_t>(bin.weight), std::exp(bin.sum / bin.weight)});
    }
    return result;
  }

 private:
  struct Bin {
    double weight = 0.0;
    double sum = 0.0;
  };
  double step_;
  std::map<int, Bin> bins_;
};

}  // namespace

void IntensitySamples::add(const Scan& scan, const Segmentation& seg) {
  for (const Point& p : scan.points) {
    if (std::isfinite(p.intensity)) greatest_ = std::max(greatest_, double{p.intensity});
  }
  for (const Segment& segment : seg.segments) {
    std::vector<Value> values;
    for (std::uint32_t i : segment.points) {
      const Surface& surface = seg.surfaces[i];
      const Eigen::Vector3f x = scan.points[i].position();
      const float range = x.norm();
      const float cosine = std::abs(surface.normal.dot(x)) / range;
      const bool smooth = surface.hasNormal() && surface.curvature < kSmooth;
      const bool valid = double{range} >= config_.r_near && double{range} <= config_.r_cap &&
                         double{cosine} >= kLeastCosine && std::isfinite(scan.points[i].intensity);
      if (smooth && valid) values.push_back({scan.points[i].intensity, range, cosine});
    }
    addSurface(values);
  }
}

void IntensitySamples::addSurface(const std::vector<Value>& values) {
  values_.insert(values_.end(), values.begin(), values.end());
  std::map<std::pair<int, int>, std::pair<Cell, double>> sums;
  for (const Value& v : values) {
    const Eigen::Vector2d x(std::log(double{v.range} / config_.r_ref), std::log(double{v.cosine}));
    const std::pair<int, int> key{static_cast<int>(std::floor(x.x() / kRangeStep)),
                                  static_cast<int>(double{v.cosine} / kCosineStep)};
    auto& [cell, intensity] = sums[key];
    cell.weight += 1.0;
    cell.x += x;
    intensity += std::max(0.0, double{v.intensity});
  }
  std::vector<Cell> cells;
  for (const auto& [key, sum] : sums) {
    Cell cell = sum.first;
    if (cell.weight < static_cast<double>(kCellPoints) || !(sum.second > 0.0)) continue;
    cell.surface = surfaces_;
    cell.x /= cell.weight;
    cell.y = std::log(sum.second / cell.weight);
    cells.push_back(cell);
  }
  if (cells.size() < 2) return;
  cells_.insert(cells_.end(), cells.begin(), cells.end());
  ++surfaces_;
}

double IntensitySamples::quantile(double share) const {
  std::vector<float> intensities;
  intensities.reserve(values_.size());
  for (const Value& v : values_) intensities.push_back(v.intensity);
  return double{segdf::quantile(std::move(intensities), share)};
}

/// The cells with the mean of their surface taken off, which takes its material out.
std::vector<IntensitySamples::Cell> IntensitySamples::centred() const {
  std::vector<Cell> means(surfaces_);
  for (const Cell& c : cells_) {
    Cell& mean = means[c.surface];
    mean.weight += c.weight;
    mean.x += c.weight * c.x;
    mean.y += c.weight * c.y;
  }
  std::vector<Cell> cells = cells_;
  for (Cell& c : cells) {
    const Cell& mean = means[c.surface];
    c.x -= mean.x / mean.weight;
    c.y -= mean.y / mean.weight;
  }
  return cells;
}

std::optional<IntensityFit> IntensitySamples::fit() const {
  if (surfaces_ < kMinSurfaces) return std::nullopt;
  const std::vector<Cell> cells = centred();
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double weight = 0.0;
  for (const Cell& c : cells) {
    normal += c.weight * c.x * c.x.transpose();
    right += c.weight * c.y * c.x;
    weight += c.weight;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(normal / weight);
  if (!(solver.eigenvalues()[0] > kLeastSpread)) return std::nullopt;
  const Eigen::Matrix2d inverse = normal.inverse();
  const Eigen::Vector2d slope = inverse * right;
  // Errors of one surface's cells go together, those of different surfaces do not.
  std::vector<Eigen::Vector2d> scores(surfaces_, Eigen::Vector2d::Zero());
  for (const Cell& c : cells) scores[c.surface] += c.weight * (c.y - slope.dot(c.x)) * c.x;
  Eigen::Matrix2d middle = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& score : scores) middle += score * score.transpose();
  const Eigen::Matrix2d covariance = inverse * middle * inverse;
  IntensityFit fit{-slope.x(), slope.y(), std::sqrt(covariance(0, 0)), std::sqrt(covariance(1, 1)),
                   {},         {}};
  addBins(slope, fit);
  return fit;
}

/// What is left of each cell when the surface and the other influence are taken off.
void IntensitySamples::addBins(const Eigen::Vector2d& slope, IntensityFit& fit) const {
  std::vector<double> level(surfaces_, 0.0);
  std::vector<double> weight(surfaces_, 0.0);
  for (const Cell& c : cells_) {
    level[c.surface] += c.weight * (c.y - slope.dot(c.x));
    weight[c.surface] += c.weight;
  }
  Bins range(kRangeStep);
  Bins cosine(kCosineStep);
  for (const Cell& c : cells_) {
    const double relative = c.y - level[c.surface] / weight[c.surface];
    range.add(c.x.x(), relative - slope.y() * c.x.y(), c.weight);
    cosine.add(std::exp(c.x.y()), relative - slope.x() * c.x.x(), c.weight);
  }
  fit.by_range = range.list([this](double x) { return config_.r_ref * std::exp(x); });
  fit.by_cosine = cosine.list([](double x) { return x; });
}

/// By the scale of the values alone.
IntensityProfile IntensitySamples::compensatedProfile() const {
  if (greatest_ <= kUnit) return IntensityProfile::kKittiHdl64;
  const double diffuse = intensityModel(IntensityProfile::kVelodyneReflectivity).full_scale;
  return quantile(kDiffuseShare) <= diffuse ? IntensityProfile::kVelodyneReflectivity
                                            : IntensityProfile::kOusterReflectivity;
}

/// Sensor value, at r_ref and facing, that few exceed.
double IntensitySamples::filledScale(IntensityProfile profile) const {
  const IntensityModel model = intensityModel(profile);
  std::vector<double> values;
  values.reserve(values_.size());
  for (const Value& v : values_) {
    values.push_back(double{v.intensity} *
                     calibrationGain(double{v.range}, double{v.cosine}, model, config_));
  }
  return toThreeDigits(segdf::quantile(std::move(values), kFull));
}

IntensityProposal IntensitySamples::propose(const IntensityFit& fit) const {
  const IntensityProfile compensated = compensatedProfile();
  const IntensityProfile modelled =
      greatest_ <= kUnit ? IntensityProfile::kRaw : IntensityProfile::kOusterSignal;
  const double to_compensated = distanceTo(fit, intensityModel(compensated));
  const double to_modelled = distanceTo(fit, intensityModel(modelled));
  IntensityProposal proposal;
  proposal.config = config_;
  proposal.config.profile = to_compensated <= to_modelled ? compensated : modelled;
  const double error = std::hypot(fit.range_error, fit.incidence_error);
  proposal.certain = std::min(to_compensated, to_modelled) < kFarthest &&
                     std::abs(to_compensated - to_modelled) > kErrors * error;
  proposal.full_scale = filledScale(proposal.config.profile);
  const double ratio = proposal.full_scale / intensityModel(proposal.config.profile).full_scale;
  const bool fits = ratio <= kScaleFactor && ratio >= 1.0 / kScaleFactor;
  proposal.config.full_scale = fits ? 0.0 : proposal.full_scale;
  return proposal;
}

}  // namespace segdf

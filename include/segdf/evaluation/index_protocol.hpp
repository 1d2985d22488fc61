// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Kept and total of one kind of points.
struct Share {
  std::size_t part = 0;
  std::size_t whole = 0;

  /// 0..100; nothing when there is no such point, which is neither 0 nor 100.
  std::optional<double> percent() const;
};

/// Scores labels against ground truth point by point, by index: the DynamicMap benchmark's SA and
/// DA (peers.md 3.1, method.md 7.3 and 7.4) without the ambiguity of nearest neighbours. Static
/// points are all but those of classes 252..259; classes 0 and 1 are not scored, nor is anything
/// beyond the range. A point is kept iff its label's class is neither 0 (not judged, so not in the
/// map) nor 251 (dynamic).
class IndexProtocol {
 public:
  static constexpr std::size_t kMovingClasses = 8;  ///< 252..259
  static constexpr std::size_t kMinInstancePoints = 20;

  /// @param range metres from the sensor, inclusive
  explicit IndexProtocol(double range = 50.0) : range_(range) {}

  /// Adds one scan. The three lists hold the same points. @throws std::invalid_argument when they
  /// do not
  void add(const std::vector<Point>& points,
           const std::vector<std::uint32_t>& truth,
           const std::vector<std::uint32_t>& estimate);

  std::size_t scoredPoints() const { return static_.whole + moving_.whole; }
  const Share& staticKept() const { return static_; }     ///< SA
  const Share& movingRemoved() const { return moving_; }  ///< DA
  const Share& parkedKept() const { return parked_; }     ///< SA over parked movables
  std::optional<double> associatedAccuracy() const;       ///< AA = sqrt(SA DA), percent
  std::optional<double> harmonicAccuracy() const;         ///< HA = 2 SA DA / (SA + DA), percent
  /// DA of class 252 + i.
  const std::array<Share, kMovingClasses>& movingByClass() const { return by_class_; }
  /// Moving instances (truth id not 0) of at least kMinInstancePoints points over all scans:
  /// removed, that is at least half of their points are, of all.
  Share instancesRemoved() const;

 private:
  using InstanceKey = std::pair<std::uint16_t, std::uint16_t>;  // class, id

  void addPoint(std::uint32_t truth, std::uint32_t estimate);

  double range_;
  Share static_;
  Share moving_;
  Share parked_;
  std::array<Share, kMovingClasses> by_class_{};
  std::map<InstanceKey, Share> instances_;
};

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace segdf {

/// Kept and total of one kind of points.
struct Share {
  std::size_t part = 0;
  std::size_t whole = 0;

  void count(bool hit) {
    ++whole;
    part += hit ? 1 : 0;
  }
  /// 0..100; nothing when there is no such point, which is neither 0 nor 100.
  std::optional<double> percent() const;
};

/// Adds up which points of the ground truth are kept in the map: SA, DA, AA and HA of method.md 7.3
/// and the figures of 7.4. Static points are all but those of classes 252..259; classes 0 and 1 are
/// not scored. How it is known that a point is kept is the protocol's matter.
class PointScores {
 public:
  static constexpr std::size_t kBands = 6;    ///< of range
  static constexpr double kBandWidth = 10.0;  ///< metres; the last band has no end
  static constexpr std::size_t kMinInstancePoints = 20;

  using ByBand = std::array<Share, kBands>;
  using InstanceKey = std::pair<std::uint16_t, std::uint16_t>;  ///< class, id

  /// @param truth label; @param range metres from the sensor; @param kept in the map
  void add(std::uint32_t truth, double range, bool kept);

  std::size_t scoredPoints() const { return static_.whole + moving_.whole; }
  const Share& staticKept() const { return static_; }     ///< SA
  const Share& movingRemoved() const { return moving_; }  ///< DA
  const Share& parkedKept() const { return parked_; }     ///< SA over parked movables
  const Share& groundKept() const { return ground_; }     ///< SA over the classes of the ground
  std::optional<double> associatedAccuracy() const;       ///< AA = sqrt(SA DA), percent
  std::optional<double> harmonicAccuracy() const;         ///< HA = 2 SA DA / (SA + DA), percent
  /// Scored right by class and range band: kept for a static class, removed for a moving one.
  const std::map<std::uint16_t, ByBand>& rightByClass() const { return by_class_; }
  ByBand staticKeptByBand() const { return sumByBand(false); }
  ByBand movingRemovedByBand() const { return sumByBand(true); }
  /// All bands of one class.
  Share rightOfClass(std::uint16_t semantic_class) const;
  /// Moving instances (truth id not 0) of at least kMinInstancePoints points over all scans:
  /// removed, that is at least half of their points are, of all.
  Share instancesRemoved() const { return instancesHalfRemoved(true); }
  /// The same of static instances: each one removed is a mistake.
  Share falseInstances() const { return instancesHalfRemoved(false); }
  /// Removed points of every instance with an id.
  const std::map<InstanceKey, Share>& removedByInstance() const { return instances_; }

 private:
  ByBand sumByBand(bool moving) const;
  Share instancesHalfRemoved(bool moving) const;

  Share static_;
  Share moving_;
  Share parked_;
  Share ground_;
  std::map<std::uint16_t, ByBand> by_class_;
  std::map<InstanceKey, Share> instances_;
};

}  // namespace segdf

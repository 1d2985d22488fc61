// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace segdf {

/// What became of a point, set against the truth. The page knows these numbers.
enum class PointFate : std::uint8_t {
  kKeptStatic = 0,
  kRemovedMoving = 1,
  kKeptMoving = 2,     ///< a mistake: it is still in the map
  kRemovedStatic = 3,  ///< a mistake: it is lost
  kNotScored = 4,      ///< classes 0 and 1
};

/// One point of the interactive view.
struct ViewPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< metres, map frame
  std::uint16_t semantic_class = 0;                    ///< of the truth
  std::uint16_t instance = 0;                          ///< 0 = none
  std::uint8_t intensity = 0;
  PointFate fate = PointFate::kKeptStatic;
};

/// Points as a page holds them: per point three int16 (position - origin) / step, then for all
/// points the instances (uint16), then intensities, then indices into `classes`, then fates (a byte
/// each), little-endian.
struct PackedCloud {
  std::size_t count = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< metres
  double step = 1.0;                                 ///< metres
  double voxel = 0.0;                                ///< at most one point of a fate in it, metres
  std::vector<std::uint16_t> classes;                ///< at most 256
  std::string bytes;
};

/// Collects the points of a drive for the view and thins them as they come, on a grid that widens
/// until they are few enough. Each fate has voxels of its own, so that a mistake is never hidden by
/// what is right. Memory stays below about 150 MB for a drive of any length.
class ViewCloud {
 public:
  static constexpr std::size_t kMostPoints = 1500000;

  /// @param most_points in the end
  explicit ViewCloud(std::size_t most_points = kMostPoints) : most_points_(most_points) {}

  /// @param point finite
  void add(const ViewPoint& point);
  PackedCloud finish();

 private:
  void thin();
  void thinTo(std::size_t limit);

  std::size_t most_points_;
  double voxel_ = 0.08;  // metres: finer cannot be seen when a street fills the screen
  std::vector<ViewPoint> points_;
};

}  // namespace segdf

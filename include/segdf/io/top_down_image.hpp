// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <Eigen/Geometry>

#include "segdf/mapping/map_point.hpp"

namespace segdf {

/// The map seen from above, x to the right and y up: ground grey by intensity, instances coloured
/// by class and brighter the higher they are, removed points in red on top, the sensor's way as a
/// yellow line, a white bar of 10 m at the lower left.
class TopDownImage {
 public:
  /// @param trajectory sensor positions in the map frame, metres; the picture reaches 50 m around
  /// them, at 0.05 m a pixel or as much as makes its longer side 4000 pixels
  explicit TopDownImage(std::vector<Eigen::Vector2d> trajectory);

  void add(const MapPoint& point);

  /// Writes beside and renames. @throws IoError
  void write(const std::filesystem::path& file);

 private:
  /// A point that is to be drawn.
  struct Dot {
    std::size_t pixel = 0;
    std::uint32_t cell = 0;
  };

  void drawWaiting();
  /// Index of the pixel at a place, cells_.size() outside the picture.
  std::size_t pixelAt(double x, double y) const;
  void drawTrajectory(std::vector<std::uint8_t>& pixels) const;
  void drawScale(std::vector<std::uint8_t>& pixels) const;

  std::vector<Eigen::Vector2d> trajectory_;
  Eigen::AlignedBox2d area_;
  double metres_per_pixel_;
  std::size_t width_;
  std::size_t height_;
  std::vector<std::uint32_t> cells_;  ///< what is on top
  std::array<Dot, 32> waiting_;
  std::size_t waiting_count_ = 0;
};

}  // namespace segdf

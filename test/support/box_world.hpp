// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "segdf/core/scan.hpp"

namespace segdf::test {

/// Upright box that a ray can hit. Metres, map frame, sides along x, y and z.
struct Box {
  Eigen::Vector3d center;
  Eigen::Vector3d size;
  float intensity = 0.5F;
};

/// Flat ground at z = 0 with boxes on it, seen without noise by a spinning sensor: the smallest
/// scene in which the expected answer can be worked out by hand. Brute force; the real simulator is
/// in simulation/.
class BoxWorld {
 public:
  /// Box standing on the ground. @returns its index
  std::size_t add(
      double x, double y, double length, double width, double height, float intensity = 0.5F);
  void moveTo(std::size_t box, double x, double y);

  /// Scan from a sensor 1.73 m above the ground at (x, y), heading in degrees: 64 lasers from +2 to
  /// -24.8 degrees, `columns` columns, ring-major, 60 m reach.
  Scan scan(
      double x, double y, double heading_deg, std::int64_t stamp_ns, int columns = 1000) const;

 private:
  std::vector<Box> boxes_;
};

/// Walls on both sides of the x axis and a few poles: something to register and to compare with.
BoxWorld makeStreet();

/// Points uniformly inside a box, from a fixed generator.
std::vector<Point> randomBlob(const Eigen::Vector3d& center,
                              const Eigen::Vector3d& size,
                              std::size_t count,
                              std::uint32_t seed);

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include "segdf/core/scan.hpp"

namespace segdf::test {

/// Points anywhere within 50 m, with rings 0..15 and times, at a pose 100 m from the origin and
/// turned about all axes. Same seed, same scan.
inline Scan sampleScan(std::size_t points, std::int64_t stamp_ns, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-50.0F, 50.0F);
  std::uniform_real_distribution<float> intensity(0.0F, 1.0F);
  Scan scan;
  scan.stamp_ns = stamp_ns;
  scan.pose = Eigen::Translation3d(100.0, -40.0, 2.0) *
              Eigen::AngleAxisd(0.7, Eigen::Vector3d(0.1, 0.2, 1.0).normalized());
  for (std::size_t i = 0; i < points; ++i) {
    Point point;
    point.x = coordinate(random);
    point.y = coordinate(random);
    point.z = coordinate(random);
    point.intensity = intensity(random);
    point.time = 0.1F * static_cast<float>(i) / static_cast<float>(points);
    point.ring = static_cast<std::int16_t>(i % 16);
    scan.points.push_back(point);
  }
  return scan;
}

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "segdf/core/scan.hpp"

namespace segdf {

/// Ensemble of shape functions (Wohlkinger and Vincze; method.md 5.3): ten histograms over random
/// triples of a cluster's points, of 64 bins each: angle A3, square root of area D3 and distance
/// D2, each for connecting lines inside, outside and partly inside the surface, and the share of
/// the latter lines that lies inside. Dimensionless; the sum of all bins is 1.
struct ShapeHistogram {
  static constexpr std::size_t kHistograms = 10;
  static constexpr std::size_t kBins = 64;
  static constexpr std::size_t kPooledBins = 9;

  using Pooled = std::array<float, kHistograms * kPooledBins>;

  std::array<float, kHistograms * kBins> bins{};  ///< all 0 unless valid
  /// False for fewer than 10 points, and where hardly any three points span a triangle.
  bool valid = false;

  /// The 90 of the draft's vector of 120: bin b of each histogram goes to bin floor(9 b / 64).
  Pooled pooled() const;
};

/// The triples are drawn by a generator that is seeded with the cluster's coordinates: the same
/// points give the same histogram in any order, on any thread.
ShapeHistogram shapeHistogram(const std::vector<Point>& points,
                              const std::vector<std::uint32_t>& indices);

/// Sum of the absolute differences of the bins, 0 to 2.
float distance(const ShapeHistogram::Pooled& a, const ShapeHistogram::Pooled& b);

}  // namespace segdf

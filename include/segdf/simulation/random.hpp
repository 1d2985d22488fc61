// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace segdf {

/// Small random generator (splitmix64) whose numbers are the same with every compiler and library;
/// the standard distributions are not. Streams are told apart by what they are seeded with, e.g.
/// (seed, scan, ray), so that the order of use does not matter.
class Random {
 public:
  explicit Random(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0)
      : state_(mix(mix(mix(a) + b) + c)) {}

  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// True with the given probability.
  bool chance(double probability) { return uniform() < probability; }
  /// Nearly standard normal: the sum of four uniform numbers, hence never beyond 3.5. It costs a
  /// tenth of an exact one, and a scan draws half a million.
  double normal() {
    constexpr double kScale = 1.7320508075688772 / 65536.0;  // sqrt(12 / 4), of 16 bits each
    const std::uint64_t bits = next();
    std::uint64_t sum = 0;
    for (unsigned shift = 0; shift < 64U; shift += 16U) sum += (bits >> shift) & 0xFFFFU;
    return (static_cast<double>(sum) - 2.0 * 65535.0) * kScale;
  }

 private:
  static std::uint64_t mix(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ULL;
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBULL;
    return x ^ (x >> 31U);
  }
  std::uint64_t next() { return mix(state_ += 0x9E3779B97F4A7C15ULL); }

  std::uint64_t state_;
};

}  // namespace segdf

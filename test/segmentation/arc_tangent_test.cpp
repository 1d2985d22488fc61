// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/arc_tangent.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

constexpr int kSteps = 100003;  // a prime, so that no step falls on an axis or a diagonal

/// Largest difference to std::atan2 around the circle, rad.
template <class Real>
double worst(Real radius) {
  double difference = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double angle = 6.283185307179586 * (k - kSteps / 2) / kSteps;
    const Real x = radius * static_cast<Real>(std::cos(angle));
    const Real y = radius * static_cast<Real>(std::sin(angle));
    const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
    const double off = std::abs(static_cast<double>(arcTangent2(y, x)) - exact);
    difference = std::max(difference, off);
  }
  return difference;
}

// The bounds are those that the header promises.
TEST(ArcTangent, IsAsExactAsItSays) {
  for (double radius : {1e-3, 1.0, 300.0}) {
    EXPECT_LT(worst(radius), 2e-8) << radius;
    EXPECT_LT(worst(static_cast<float>(radius)), 1e-6) << radius;
  }
}

TEST(ArcTangent, KnowsTheAxesAndTheOrigin) {
  EXPECT_EQ(arcTangent2(0.0F, 0.0F), 0.0F);
  EXPECT_EQ(arcTangent2(0.0, 0.0), 0.0);
  EXPECT_FLOAT_EQ(arcTangent2(0.0F, -1.0F), 3.14159265F);
  EXPECT_FLOAT_EQ(arcTangent2(2.0F, 0.0F), 1.57079633F);
  EXPECT_FLOAT_EQ(arcTangent2(-2.0F, 0.0F), -1.57079633F);
}

}  // namespace
}  // namespace segdf

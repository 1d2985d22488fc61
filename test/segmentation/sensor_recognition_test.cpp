// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/sensor_recognition.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

/// Returns at 10 m from lasers evenly spread between two elevations.
Scan fan(int beams, double low_deg, double high_deg, bool with_rings) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  Scan scan;
  for (int beam = 0; beam < beams; ++beam) {
    const double e = (low_deg + (high_deg - low_deg) * beam / (beams - 1)) * kRadians;
    for (int column = 0; column < 360; ++column) {
      const double a = column * kRadians;
      Point p;
      p.x = static_cast<float>(10.0 * std::cos(e) * std::cos(a));
      p.y = static_cast<float>(10.0 * std::cos(e) * std::sin(a));
      p.z = static_cast<float>(10.0 * std::sin(e));
      p.ring = with_rings ? static_cast<std::int16_t>(beam) : std::int16_t{-1};
      scan.points.push_back(p);
    }
  }
  return scan;
}

TEST(SensorRecognition, KnowsItsFourSensorsWithAndWithoutRings) {
  for (bool rings : {true, false}) {
    EXPECT_EQ(recogniseSensor(fan(64, -24.8, 2.0, rings)).name, "hdl64");
    EXPECT_EQ(recogniseSensor(fan(32, -30.67, 10.67, rings)).name, "hdl32");
    EXPECT_EQ(recogniseSensor(fan(16, -15.0, 15.0, rings)).name, "vlp16");
    EXPECT_EQ(recogniseSensor(fan(64, -22.5, 22.5, rings)).name, "os1_64");
    EXPECT_EQ(recogniseSensor(fan(64, -16.6, 16.6, rings)).name, "os1_64");
  }
}

TEST(SensorRecognition, AMatchIsCertainAndAStrangerIsNot) {
  EXPECT_TRUE(recogniseSensor(fan(16, -15.0, 15.0, true)).certain);
  EXPECT_FALSE(recogniseSensor(fan(128, -25.0, 15.0, true)).certain);
  EXPECT_FALSE(recogniseSensor(Scan{}).certain);
}

}  // namespace
}  // namespace segdf

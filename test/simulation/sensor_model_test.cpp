// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/simulation/sensor_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <gtest/gtest.h>

namespace segdf {
namespace {

RayHit hitAt(double range, double cosine, float reflectance) {
  RayHit hit;
  hit.range = range;
  hit.cos_incidence = cosine;
  hit.material.reflectance = reflectance;
  return hit;
}

TEST(SensorModel, TablesAreThoseOfTheSensors) {
  const SensorModel hdl64 = sensorModel("hdl64");
  ASSERT_EQ(hdl64.elevations.size(), 64U);
  EXPECT_DOUBLE_EQ(hdl64.elevations.front(), 2.66);
  EXPECT_DOUBLE_EQ(hdl64.elevations.back(), -23.68);
  EXPECT_EQ(sensorModel("hdl32").elevations.size(), 32U);
  const SensorModel vlp16 = sensorModel("vlp16");
  ASSERT_EQ(vlp16.elevations.size(), 16U);
  for (std::size_t k = 0; k < 16; ++k) {
    EXPECT_NEAR(vlp16.elevations[k], 15.0 - 2.0 * static_cast<double>(k), 1e-12);
  }
  EXPECT_EQ(sensorModel("os1_64").columns, 1024);
  for (const char* name : {"hdl64", "hdl32", "vlp16", "os1_64"}) {
    const auto& e = sensorModel(name).elevations;
    EXPECT_TRUE(std::is_sorted(e.begin(), e.end(), std::greater<>())) << name << ": topmost first";
  }
  EXPECT_THROW(sensorModel("hdl65"), std::invalid_argument);
}

TEST(SensorModel, IntensitiesAreInTheSensorsUnit) {
  const SensorModel kitti = sensorModel("hdl64");
  const SensorModel velodyne = sensorModel("vlp16");
  for (std::uint64_t k = 0; k < 200; ++k) {
    Random random(k);
    const float i = modelIntensity(kitti, hitAt(12.0, 1.0, 0.4F), 1.0, random);
    EXPECT_GE(i, 0.0F);
    EXPECT_LE(i, 0.99F);
    EXPECT_NEAR(i * 100.0F, std::round(i * 100.0F), 1e-4F);
    EXPECT_LE(modelIntensity(velodyne, hitAt(12.0, 1.0, 0.9F), 1.0, random), 100.0F);
    EXPECT_GT(modelIntensity(velodyne, hitAt(12.0, 1.0, 1.5F), 1.0, random), 100.0F) << "retro";
  }
}

TEST(SensorModel, GlassAndDarknessLosePulses) {
  const SensorModel sensor = sensorModel("hdl64");
  int plain = 0;
  int glass = 0;
  int through = 0;
  int far = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    Random random(k, 3);
    plain += fateOf(sensor, hitAt(10.0, 1.0, 0.3F), random) == Fate::kLost ? 1 : 0;
    RayHit window = hitAt(10.0, 1.0, 0.1F);
    window.material.glass = true;
    const Fate fate = fateOf(sensor, window, random);
    glass += fate == Fate::kLost ? 1 : 0;
    through += fate == Fate::kThrough ? 1 : 0;
    far += fateOf(sensor, hitAt(60.0, 1.0, 0.05F), random) == Fate::kLost ? 1 : 0;
  }
  // 2 %, 35 % and 35 %, each within four sigma of 2000 draws.
  EXPECT_NEAR(plain, 40, 26);
  EXPECT_NEAR(glass, 700, 86);
  EXPECT_NEAR(through, 700, 86);
  EXPECT_EQ(far, 2000) << "a reflectance of 0.05 is seen to 40 m";
}

TEST(SensorModel, TheOwnRoofTakesTheSteepBeamsToTheRear) {
  const OwnRoof roof;
  const auto beam = [](double azimuth, double elevation) {
    return Eigen::Vector3d(std::cos(elevation) * std::cos(azimuth),
                           std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  };
  // 0.35 m below the sensor a beam of -20 degrees has gone 0.96 m: beyond the roof's front edge and
  // its side, but not beyond its rear edge.
  EXPECT_FALSE(hitsRoof(roof, beam(0.0, -0.349)));
  EXPECT_FALSE(hitsRoof(roof, beam(1.571, -0.349)));
  EXPECT_TRUE(hitsRoof(roof, beam(3.1416, -0.349)));
  EXPECT_FALSE(hitsRoof(roof, beam(3.1416, -0.1))) << "3.5 m";
  EXPECT_FALSE(hitsRoof(roof, beam(3.1416, 0.1))) << "upwards";
}

}  // namespace
}  // namespace segdf

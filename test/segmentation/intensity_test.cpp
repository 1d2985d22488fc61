// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/segmentation/intensity.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace segdf {
namespace {

float calibrated(float x,
                 float intensity,
                 const Eigen::Vector3f& normal,
                 IntensityProfile profile) {
  IntensityConfig config;
  config.profile = profile;
  Surface surface;
  surface.normal = normal;
  return calibrateIntensity({{x, 0.0F, 0.0F, intensity, 0.0F, -1}}, {surface}, config)[0];
}

const Eigen::Vector3f kFacing(-1.0F, 0.0F, 0.0F);
const Eigen::Vector3f kTilted(-0.5F, 0.8660254F, 0.0F);  // 60 degrees: cos = 0.5
const Eigen::Vector3f kGrazing(-0.1F, 0.9949874F, 0.0F);

TEST(Intensity, LiteralIsFormula6) {
  // (20 / 10)^2 * 0.1 = 0.4 facing, twice that at 60 degrees.
  EXPECT_NEAR(calibrated(20.0F, 0.1F, kFacing, IntensityProfile::kLiteral), 0.4F, 1e-5);
  EXPECT_NEAR(calibrated(20.0F, 0.1F, kTilted, IntensityProfile::kLiteral), 0.8F, 1e-5);
}

TEST(Intensity, GuardsLimitRangeAndAngle) {
  EXPECT_NEAR(calibrated(2.0F, 0.1F, kFacing, IntensityProfile::kLiteral), 0.1F, 1e-6);    // r_near
  EXPECT_NEAR(calibrated(200.0F, 0.1F, kFacing, IntensityProfile::kLiteral), 3.6F, 1e-5);  // r_cap
  EXPECT_NEAR(calibrated(10.0F, 0.1F, kGrazing, IntensityProfile::kLiteral), 0.5F, 1e-5);  // c_min
}

TEST(Intensity, AnUnknownNormalLeavesTheAngleOut) {
  EXPECT_NEAR(calibrated(20.0F, 0.1F, Eigen::Vector3f::Zero(), IntensityProfile::kLiteral), 0.4F,
              1e-5);
}

TEST(Intensity, CompensatedSensorsAreOnlyScaled) {
  EXPECT_FLOAT_EQ(calibrated(40.0F, 0.3F, kTilted, IntensityProfile::kKittiHdl64), 0.3F);
  EXPECT_FLOAT_EQ(calibrated(40.0F, 51.0F, kTilted, IntensityProfile::kOusterReflectivity), 0.2F);
  EXPECT_FLOAT_EQ(calibrated(40.0F, 50.0F, kTilted, IntensityProfile::kVelodyneReflectivity), 0.5F);
}

TEST(Intensity, RetroReflectorsAreClipped) {
  EXPECT_FLOAT_EQ(calibrated(40.0F, 255.0F, kFacing, IntensityProfile::kVelodyneReflectivity),
                  1.0F);
}

TEST(Intensity, AFullScaleOfItsOwnReplacesTheProfiles) {
  IntensityConfig config;
  config.profile = IntensityProfile::kOusterReflectivity;
  config.full_scale = 1000.0;
  const Point point{10.0F, 0.0F, 0.0F, 250.0F, 0.0F, -1};
  EXPECT_FLOAT_EQ(calibrateIntensity({point}, {Surface{}}, config)[0], 0.25F);
}

TEST(Intensity, NonsenseBecomesZero) {
  EXPECT_EQ(calibrated(10.0F, std::nanf(""), kFacing, IntensityProfile::kLiteral), 0.0F);
  EXPECT_EQ(calibrated(10.0F, -3.0F, kFacing, IntensityProfile::kLiteral), 0.0F);
  EXPECT_EQ(calibrated(std::nanf(""), 0.5F, kFacing, IntensityProfile::kLiteral), 0.0F);
}

}  // namespace
}  // namespace segdf

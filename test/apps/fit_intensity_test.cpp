// SPDX-License-Identifier: BSD-3-Clause
// segdf_fit_intensity as a user calls it.
#include <fstream>

#include "segdf/io/config_yaml.hpp"

#include "drive_fixture.hpp"

namespace segdf {
namespace {

namespace fs = std::filesystem;
using test::contains;
using test::Outcome;

class FitIntensity : public test::DriveFixture {
 protected:
  Outcome fit(const std::string& arguments) const {
    return test::run(std::string(SEGDF_FIT_INTENSITY) + " " + arguments, folder_.path());
  }
  fs::path plot() const { return folder_ / "fit.png"; }
  /// Scans from all over the mixed drive.
  std::string simulate(const std::string& sensor, const std::string& intensity) const {
    const fs::path made = folder_ / (sensor + "_" + intensity);
    const Outcome outcome =
        test::run(std::string(SEGDF_SIMULATE) + " --seed 3 --scans 8 --rate 0.5 --sensor " +
                      sensor + " --intensity " + intensity + " --output " + made.string(),
                  folder_.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return made.string();
  }
  /// Gives every point of the drive one intensity.
  void fillIntensity(float value) const {
    for (int k = 0; k < kScans; ++k) {
      std::fstream file(scanFile("00000" + std::to_string(k)),
                        std::ios::in | std::ios::out | std::ios::binary);
      const auto points = fs::file_size(scanFile("00000" + std::to_string(k))) / 16;
      for (std::size_t i = 0; i < points; ++i) {
        file.seekp(static_cast<std::streamoff>(16 * i + 12));
        file.write(reinterpret_cast<const char*>(&value), sizeof(value));
      }
    }
  }
  void expectFailure(const Outcome& outcome, int status, const std::string& part) const {
    expectError(outcome, status, part);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(plot()));
  }
};

TEST_F(FitIntensity, FindsTheModelOfEverySimulatedSensor) {
  for (const char* sensor : {"hdl64", "hdl32", "vlp16", "os1_64"}) {
    for (const auto& [model, profile] :
         {std::pair{"raw", IntensityProfile::kRaw}, {"kitti", IntensityProfile::kKittiHdl64}}) {
      const Outcome outcome =
          fit("--kitti " + simulate(sensor, model) + " --plot " + plot().string());
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.errorLines("warning: "), 0) << sensor << outcome.err;
      EXPECT_EQ(test::readText(plot()).substr(1, 3), "PNG");
      Config config;
      config.intensity.profile = IntensityProfile::kLiteral;
      applyYaml(config, outcome.out, "what is printed");  // goes into --config as it is
      EXPECT_EQ(config.intensity.profile, profile) << sensor << '\n' << outcome.out;
      EXPECT_EQ(config.intensity.full_scale, 0.0) << outcome.out;
    }
  }
}

TEST_F(FitIntensity, FolderAndBagGiveTheSameProposal) {
  const std::string simulated = simulate("vlp16", "raw");
  ASSERT_EQ(test::run(std::string(SEGDF_KITTI_TO_BAG) + " --kitti " + simulated + " --output " +
                          bag().string(),
                      folder_.path())
                .status,
            0);
  for (const std::string& input : {"--kitti " + simulated, "--bag " + bag().string()}) {
    const Outcome outcome = fit(input + " --scans 4");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "# 4 scans"));
    EXPECT_TRUE(contains(outcome.out, "intensity:\n  profile: raw\n"));
  }
}

TEST_F(FitIntensity, NoDrive) { expectFailure(fit(""), 2, "--bag FILE or --kitti DIR"); }

TEST_F(FitIntensity, MissingFolder) {
  expectFailure(fit("--kitti /nowhere"), 1, "no folder /nowhere/velodyne");
}

TEST_F(FitIntensity, IntensitiesThatAreAllZero) {
  fillIntensity(0.0F);
  expectFailure(fit("--kitti " + drive().string()), 1, "no intensity above 0 in 5 scans of");
}

TEST_F(FitIntensity, TooFewSurfaces) {
  // The street of the fixture has a handful of boxes.
  expectFailure(fit("--scans 1 --kitti " + drive().string() + " --plot " + plot().string()), 1,
                "too little to fit in 1 scans of");
}

TEST_F(FitIntensity, APlotThatCannotBeWritten) {
  const Outcome outcome = fit("--kitti " + simulate("vlp16", "raw") + " --plot /nowhere/fit.png");
  expectFailure(outcome, 1, "/nowhere/fit.png");
}

}  // namespace
}  // namespace segdf

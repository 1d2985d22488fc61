// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/config_yaml.hpp"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace segdf {
namespace {

using test::contains;
using test::errorOf;

std::string complaintAbout(const std::string& yaml) {
  Config config;
  return errorOf([&] { applyYaml(config, yaml, "my.yaml"); });
}

TEST(ConfigYaml, OverwritesWhatIsNamedAndLeavesTheRest) {
  Config config;
  applyYaml(config,
            "ground: {th_seed: 0.5, n_min: 12, elevation: [1, 2, 3, 4]}\n"
            "intensity: {profile: raw}\n",
            "test");
  EXPECT_EQ(config.ground.th_seed, 0.5);
  EXPECT_EQ(config.ground.n_min, 12);
  EXPECT_EQ(config.ground.elevation[3], 4.0);
  EXPECT_EQ(config.intensity.profile, IntensityProfile::kRaw);
  EXPECT_EQ(config.ground.l_max, Config{}.ground.l_max);
}

TEST(ConfigYaml, AnUnknownParameterIsNamedWithTheKnownOnes) {
  const std::string message = complaintAbout("ground: {th_sed: 0.5}");
  EXPECT_TRUE(contains(message, "my.yaml: unknown parameter 'ground.th_sed'"));
  EXPECT_TRUE(contains(message, "th_seed"));
  EXPECT_TRUE(contains(complaintAbout("gruond: {th_seed: 0.5}"), "unknown parameter 'gruond'"));
}

TEST(ConfigYaml, AValueOfTheWrongKindIsNamed) {
  EXPECT_TRUE(contains(complaintAbout("ground: {th_seed: much}"),
                       "parameter ground.th_seed = much must be a number"));
  EXPECT_TRUE(contains(complaintAbout("ground: {n_min: 2.5}"), "must be a whole number"));
  EXPECT_TRUE(contains(complaintAbout("ground: {elevation: [1, 2]}"), "a list of 4 numbers"));
  EXPECT_TRUE(contains(complaintAbout("cvi: {gate: maybe}"),
                       "parameter cvi.gate = maybe is not one of: off, evidence, literal"));
  EXPECT_TRUE(contains(complaintAbout("ground: 3"), "ground must hold parameters"));
}

TEST(ConfigYaml, AValueOutOfBoundsIsNamed) {
  EXPECT_TRUE(
      contains(complaintAbout("cvi: {dphi: 99}"), "parameter cvi.dphi = 99 is out of [0.05, 30]"));
}

TEST(ConfigYaml, BrokenYamlIsNamedWithItsLine) {
  EXPECT_TRUE(contains(complaintAbout("ground:\n  th_seed: [0.5\n"), "my.yaml: line"));
}

TEST(ConfigYaml, NothingIsFine) { EXPECT_EQ(complaintAbout(""), ""); }

TEST(ConfigYaml, AMissingFileIsNamed) {
  Config config;
  EXPECT_TRUE(
      contains(errorOf([&] { applyYamlFile(config, "/nowhere/x.yaml"); }), "/nowhere/x.yaml"));
}

TEST(ConfigYaml, WhatIsWrittenReadsBackTheSame) {
  Config changed;
  changed.ground.th_seed = 1.0 / 3.0;
  changed.cvi.gate = IntensityGate::kEvidence;
  changed.input.ego_box = {-1.5, 2.5, -0.75, 0.75};
  Config read;
  applyYaml(read, toYaml(changed), "test");
  EXPECT_EQ(toYaml(read), toYaml(changed));
  EXPECT_EQ(read.ground.th_seed, changed.ground.th_seed);
}

TEST(ConfigYaml, EverySensorThatShipsIsValid) {
  EXPECT_EQ(knownSensors(), (std::vector<std::string>{"hdl32", "hdl64", "os1_64", "vlp16"}));
  for (const std::string& sensor : knownSensors()) EXPECT_NO_THROW(sensorConfig(sensor)) << sensor;
  EXPECT_EQ(sensorConfig("vlp16").range_image.beams, 16);
  EXPECT_TRUE(contains(errorOf([] { sensorConfig("hdl65"); }), "unknown sensor 'hdl65'"));
}

/// cfg/segdf.yaml is the defaults with unit and range on every line. After a change of a default:
/// segdf_offline --print-config > cfg/segdf.yaml
TEST(ConfigYaml, TheShippedFileIsTheDefaults) {
  std::ifstream file(std::string(SEGDF_SOURCE_DIR) + "/cfg/segdf.yaml");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), toYaml(Config{}));
}

}  // namespace
}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/parameters.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "segdf/io/config_yaml.hpp"

#include "support/expect_error.hpp"

namespace segdf {
namespace {

using XmlRpc::XmlRpcValue;

std::string refusal(const XmlRpcValue& tree) {
  try {
    splitParameters(tree);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Parameters, NothingGivenMeansDefaults) {
  const PrivateParameters parameters = splitParameters(XmlRpcValue());
  EXPECT_EQ(parameters.node.sensor, "auto");
  EXPECT_EQ(parameters.node.queue_size, NodeParameters().queue_size);
  EXPECT_EQ(parameters.config_yaml, "");
}

TEST(Parameters, NodeParametersAreSplitFromTheConfiguration) {
  XmlRpcValue tree;
  tree["sensor"] = "vlp16";
  tree["threads"] = 3;
  tree["queue_size"] = 20;
  tree["map_every"] = 5;
  tree["ground"]["th_seed"] = 0.25;
  const PrivateParameters parameters = splitParameters(tree);
  EXPECT_EQ(parameters.node.sensor, "vlp16");
  EXPECT_EQ(parameters.node.threads, 3);
  EXPECT_EQ(parameters.node.queue_size, 20);
  EXPECT_EQ(parameters.node.display.map_every, 5);
  const YAML::Node config = YAML::Load(parameters.config_yaml);
  EXPECT_EQ(config.size(), 1U);
  EXPECT_EQ(config["ground"]["th_seed"].as<double>(), 0.25);
}

TEST(Parameters, YamlKeepsEveryKindOfValue) {
  XmlRpcValue tree;
  tree["number"] = 0.1 + 0.2;  // needs 17 digits
  tree["whole"] = -4;
  tree["flag"] = true;
  tree["text"] = "odd: text";
  tree["list"][0] = 1.5;
  tree["list"][1] = 2;
  tree["deep"]["deeper"]["leaf"] = 7;
  const YAML::Node read = YAML::Load(toYaml(tree));
  EXPECT_EQ(read["number"].as<double>(), 0.1 + 0.2);
  EXPECT_EQ(read["whole"].as<int>(), -4);
  EXPECT_TRUE(read["flag"].as<bool>());
  EXPECT_EQ(read["text"].as<std::string>(), "odd: text");
  EXPECT_EQ(read["list"][1].as<double>(), 2.0);
  EXPECT_EQ(read["deep"]["deeper"]["leaf"].as<int>(), 7);
}

TEST(Parameters, WrongNodeParametersAreNamedWithValueAndBound) {
  XmlRpcValue none;
  none["threads"] = 0;
  EXPECT_EQ(refusal(none), "parameter threads = 0 must be a whole number in [1, 64]");
  XmlRpcValue text;
  text["queue_size"] = "many";
  EXPECT_EQ(refusal(text), "parameter queue_size = many must be a whole number in [1, 10000]");
  XmlRpcValue number;
  number["sensor"] = 64;
  EXPECT_EQ(refusal(number), "parameter sensor = 64 must be the name of a sensor or auto");
}

TEST(Parameters, EveryKindOfNodeParameterIsRead) {
  XmlRpcValue tree;
  tree["sync_slop"] = 0.05;
  tree["output_dir"] = "/tmp/out";
  tree["use_tf"] = true;
  tree["map_frame"] = "map";
  tree["sensor_frame"] = "velodyne";
  const NodeParameters node = splitParameters(tree).node;
  EXPECT_EQ(node.sync_slop, 0.05);
  EXPECT_EQ(node.output_dir, "/tmp/out");
  EXPECT_TRUE(node.use_tf);
  EXPECT_EQ(node.map_frame, "map");
  EXPECT_EQ(node.sensor_frame, "velodyne");
  EXPECT_EQ(NodeParameters().map_frame, "odom");
}

TEST(Parameters, WrongTypesAreNamed) {
  XmlRpcValue slop;
  slop["sync_slop"] = 5;
  EXPECT_EQ(refusal(slop), "parameter sync_slop = 5 must be a number in [0, 1] s");
  XmlRpcValue flag;
  flag["use_tf"] = "yes";
  EXPECT_EQ(refusal(flag), "parameter use_tf = yes must be true or false");
  XmlRpcValue text;
  text["output_dir"] = 7;
  EXPECT_EQ(refusal(text), "parameter output_dir = 7 must be text");
}

TEST(Parameters, DisplayOptionsHaveTheBoundsOfTheirCfgFile) {
  XmlRpcValue tree;
  tree["text_size"] = 2;
  tree["map_voxel"] = 0.5;
  const DisplayConfig display = splitParameters(tree).node.display;
  EXPECT_EQ(display.text_size, 2.0);
  EXPECT_EQ(display.map_voxel, 0.5);
  EXPECT_EQ(display.box_opacity, DisplayConfig::__getDefault__().box_opacity);
  XmlRpcValue often;
  often["map_every"] = 0.5;
  EXPECT_EQ(refusal(often), "parameter map_every = 0.5 must be a whole number in [1, 10000]");
  XmlRpcValue opaque;
  opaque["box_opacity"] = 1.5;
  EXPECT_EQ(refusal(opaque), "parameter box_opacity = 1.5 must be a number in [0, 1]");
}

TEST(Parameters, FramesThatContradictEachOtherAreRefused) {
  XmlRpcValue both;
  both["use_tf"] = true;
  both["base_frame"] = "base_link";
  EXPECT_TRUE(test::contains(refusal(both), "set one of the two"));
  XmlRpcValue alone;
  alone["sensor_frame"] = "velodyne";
  EXPECT_TRUE(test::contains(refusal(alone), "needs base_frame"));
}

TEST(Parameters, ConfigurationLiesOnTopOfTheSensors) {
  XmlRpcValue tree;
  tree["ground"]["th_seed"] = 0.35;
  const Config config = makeConfig("vlp16", splitParameters(tree).config_yaml);
  EXPECT_EQ(config.ground.th_seed, 0.35);
  EXPECT_EQ(config.range_image.beams, 16);
  EXPECT_EQ(makeConfig("vlp16", "").ground.th_seed, sensorConfig("vlp16").ground.th_seed);
}

TEST(Parameters, UnknownKeysAndSensorsAreRefused) {
  XmlRpcValue key;
  key["ground"]["th_sead"] = 0.35;
  const std::string of_key =
      test::errorOf([&] { makeConfig("vlp16", splitParameters(key).config_yaml); });
  EXPECT_TRUE(test::contains(of_key, "private parameters"));
  EXPECT_TRUE(test::contains(of_key, "ground.th_sead"));
  XmlRpcValue top;
  top["queue_sice"] = 5;
  EXPECT_TRUE(test::contains(
      test::errorOf([&] { makeConfig("vlp16", splitParameters(top).config_yaml); }), "queue_sice"));
  EXPECT_TRUE(test::contains(test::errorOf([] { makeConfig("vlp_16", ""); }), "vlp_16"));
}

}  // namespace
}  // namespace segdf

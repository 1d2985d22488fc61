// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <XmlRpcValue.h>

#include <segdf/DisplayConfig.h>

#include "segdf/core/config.hpp"
#include "segdf/ros/topics.hpp"

namespace segdf {

/// What the nodelet is told beside the method's configuration.
struct NodeParameters {
  static constexpr const char* kAutoSensor = "auto";

  std::string sensor = kAutoSensor;  ///< file in cfg/sensors, or recognised on the first scan
  int threads = 2;         ///< worker threads of the pipeline, 1 to 64; no influence on results
  int queue_size = 100;    ///< scans that may wait for the filter, 1 to 10000
  double sync_slop = 0.0;  ///< seconds, 0 to 1: see Synchroniser
  std::string output_dir;  ///< where drives are written as segdf_offline does; empty: nowhere
  std::string player;      ///< node of `rosbag play` that is held while the queue is full
  bool use_tf = false;     ///< poses from tf instead of odometry
  std::string map_frame = topics::kOdometryFrame;  ///< use_tf: frame of the map
  std::string base_frame;    ///< what odometry gives the pose of; empty: the sensor
  std::string sensor_frame;  ///< empty: the cloud's own, or base_frame if that is the map's
  DisplayConfig display = DisplayConfig::__getDefault__();  ///< cfg/Display.cfg: with its bounds
};

/// The private parameters, taken apart.
struct PrivateParameters {
  NodeParameters node;
  std::string config_yaml;  ///< all other parameters: text for the strict reader of io/config_yaml
};

/// @param tree the node's private namespace: a struct, or nothing at all
/// @throws std::invalid_argument naming the parameter, its value and its bound
PrivateParameters splitParameters(const XmlRpc::XmlRpcValue& tree);

/// The sensor's configuration with the given parameters on top.
/// @param config_yaml of PrivateParameters
/// @throws IoError if the sensor or a parameter is unknown, or a value is out of bounds
Config makeConfig(const std::string& sensor, const std::string& config_yaml);

/// A parameter tree as YAML text; numbers keep all their digits.
std::string toYaml(const XmlRpc::XmlRpcValue& tree);

}  // namespace segdf

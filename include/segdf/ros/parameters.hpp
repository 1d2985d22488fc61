// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <XmlRpcValue.h>

namespace segdf {

/// What the nodelet is told beside the method's configuration.
struct NodeParameters {
  std::string sensor = "auto";  ///< file in cfg/sensors, or "auto": recognised on the first scan
  int threads = 2;       ///< worker threads of the pipeline, 1 to 64; no influence on results
  int queue_size = 100;  ///< scans that may wait, 1 to 10000
  int map_every = 10;    ///< frames between two messages on ~static_map, 1 to 10000
};

/// The private parameters, taken apart.
struct PrivateParameters {
  NodeParameters node;
  std::string config_yaml;  ///< all other parameters: text for the strict reader of io/config_yaml
};

/// @param tree the node's private namespace: a struct, or nothing at all
/// @throws std::invalid_argument naming the parameter, its value and its bound
PrivateParameters splitParameters(const XmlRpc::XmlRpcValue& tree);

/// A parameter tree as YAML text; numbers keep all their digits.
std::string toYaml(const XmlRpc::XmlRpcValue& tree);

}  // namespace segdf

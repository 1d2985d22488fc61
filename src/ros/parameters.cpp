// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/parameters.hpp"

#include <limits>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "segdf/io/config_yaml.hpp"

namespace segdf {
namespace {

using XmlRpc::XmlRpcValue;

void emit(YAML::Emitter& out, XmlRpcValue value);  // by value: XmlRpc reads only what is not const

void emitList(YAML::Emitter& out, XmlRpcValue& list) {
  out << YAML::Flow << YAML::BeginSeq;
  // NOLINTNEXTLINE(modernize-loop-convert): begin() of an XmlRpcValue is that of a struct.
  for (int i = 0; i < list.size(); ++i) emit(out, list[i]);
  out << YAML::EndSeq;
}

void emitMap(YAML::Emitter& out, XmlRpcValue& map) {
  out << YAML::BeginMap;
  for (auto& [key, value] : map) {
    out << YAML::Key << key << YAML::Value;
    emit(out, value);
  }
  out << YAML::EndMap;
}

void emit(YAML::Emitter& out, XmlRpcValue value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      out << static_cast<bool>(value);
      break;
    case XmlRpcValue::TypeInt:
      out << static_cast<int>(value);
      break;
    case XmlRpcValue::TypeDouble:
      out << static_cast<double>(value);
      break;
    case XmlRpcValue::TypeString:
      out << static_cast<std::string>(value);
      break;
    case XmlRpcValue::TypeArray:
      emitList(out, value);
      break;
    case XmlRpcValue::TypeStruct:
      emitMap(out, value);
      break;
    default:
      out << YAML::Null;
  }
}

[[noreturn]] void refuse(const std::string& name,
                         const XmlRpcValue& value,
                         const std::string& need) {
  throw std::invalid_argument("parameter " + name + " = " + toYaml(value) + " must be " + need);
}

void readInteger(const std::string& name, XmlRpcValue& value, int max, int& target) {
  const bool fits = value.getType() == XmlRpcValue::TypeInt && static_cast<int>(value) >= 1 &&
                    static_cast<int>(value) <= max;
  if (!fits) refuse(name, value, "a whole number in [1, " + std::to_string(max) + "]");
  target = value;
}

/// @return false if the nodelet itself has no such parameter
bool readNodeParameter(const std::string& name, XmlRpcValue& value, NodeParameters& node) {
  if (name == "sensor") {
    if (value.getType() != XmlRpcValue::TypeString)
      refuse(name, value, "the name of a sensor or auto");
    node.sensor = static_cast<std::string>(value);
  } else if (name == "threads") {
    readInteger(name, value, 64, node.threads);
  } else if (name == "queue_size") {
    readInteger(name, value, 10000, node.queue_size);
  } else if (name == "map_every") {
    readInteger(name, value, 10000, node.map_every);
  } else {
    return false;
  }
  return true;
}

}  // namespace

PrivateParameters splitParameters(const XmlRpcValue& tree) {
  PrivateParameters parameters;
  XmlRpcValue rest;
  if (tree.getType() == XmlRpcValue::TypeStruct) {
    XmlRpcValue all = tree;
    for (auto& [name, value] : all) {
      if (!readNodeParameter(name, value, parameters.node)) rest[name] = value;
    }
  }
  if (rest.valid()) parameters.config_yaml = toYaml(rest);
  return parameters;
}

Config makeConfig(const std::string& sensor, const std::string& config_yaml) {
  Config config = sensorConfig(sensor);
  if (!config_yaml.empty()) applyYaml(config, config_yaml, "private parameters");
  return config;
}

std::string toYaml(const XmlRpcValue& tree) {
  YAML::Emitter out;
  out.SetDoublePrecision(std::numeric_limits<double>::max_digits10);
  emit(out, tree);
  return out.c_str();
}

}  // namespace segdf

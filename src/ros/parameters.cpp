// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/parameters.hpp"

#include <functional>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <type_traits>

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

void readText(const std::string& name, XmlRpcValue& value, std::string& target) {
  if (value.getType() != XmlRpcValue::TypeString) refuse(name, value, "text");
  target = static_cast<std::string>(value);
}

void readFlag(const std::string& name, XmlRpcValue& value, bool& target) {
  if (value.getType() != XmlRpcValue::TypeBoolean) refuse(name, value, "true or false");
  target = value;
}

double numberIn(XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeInt:
      return static_cast<int>(value);
    case XmlRpcValue::TypeDouble:
      return static_cast<double>(value);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

void readSeconds(const std::string& name, XmlRpcValue& value, double& target) {
  target = numberIn(value);
  if (!(target >= 0.0 && target <= 1.0)) refuse(name, value, "a number in [0, 1] s");
}

void readSensor(const std::string& name, XmlRpcValue& value, std::string& target) {
  if (value.getType() != XmlRpcValue::TypeString) {
    refuse(name, value, "the name of a sensor or auto");
  }
  target = static_cast<std::string>(value);
}

using Reader = std::function<void(const std::string&, XmlRpcValue&, NodeParameters&)>;

template <class Value, class Read>
Reader field(Value NodeParameters::*member, const Read& read) {
  return [member, read](const std::string& name, XmlRpcValue& value, NodeParameters& node) {
    read(name, value, node.*member);
  };
}

Reader integer(int NodeParameters::*member, int max) {
  return field(member, [max](const std::string& name, XmlRpcValue& value, int& target) {
    readInteger(name, value, max, target);
  });
}

/// Bounds are those of cfg/Display.cfg. dynamic_reconfigure itself would take the nearest silently.
template <class Value>
Reader display(Value DisplayConfig::*member) {
  return [member](const std::string& name, XmlRpcValue& value, NodeParameters& node) {
    const double number = numberIn(value);
    const Value min = DisplayConfig::__getMin__().*member;
    const Value max = DisplayConfig::__getMax__().*member;
    const bool whole = std::is_integral_v<Value>;
    const bool fits = !whole || value.getType() == XmlRpcValue::TypeInt;
    if (!fits || !(number >= min && number <= max)) {
      std::ostringstream need;
      need << (whole ? "a whole number in [" : "a number in [") << min << ", " << max << "]";
      refuse(name, value, need.str());
    }
    node.display.*member = static_cast<Value>(number);
  };
}

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all{
      {"sensor", field(&NodeParameters::sensor, readSensor)},
      {"threads", integer(&NodeParameters::threads, 64)},
      {"queue_size", integer(&NodeParameters::queue_size, 10000)},
      {"sync_slop", field(&NodeParameters::sync_slop, readSeconds)},
      {"output_dir", field(&NodeParameters::output_dir, readText)},
      {"player", field(&NodeParameters::player, readText)},
      {"use_tf", field(&NodeParameters::use_tf, readFlag)},
      {"map_frame", field(&NodeParameters::map_frame, readText)},
      {"base_frame", field(&NodeParameters::base_frame, readText)},
      {"sensor_frame", field(&NodeParameters::sensor_frame, readText)},
      {"map_every", display(&DisplayConfig::map_every)},
      {"map_voxel", display(&DisplayConfig::map_voxel)},
      {"box_opacity", display(&DisplayConfig::box_opacity)},
      {"text_size", display(&DisplayConfig::text_size)},
  };
  return all;
}

/// @return false if the nodelet itself has no such parameter
bool readNodeParameter(const std::string& name, XmlRpcValue& value, NodeParameters& node) {
  const auto reader = readers().find(name);
  if (reader == readers().end()) return false;
  reader->second(name, value, node);
  return true;
}

void checkFrames(const NodeParameters& node) {
  if (node.use_tf && !node.base_frame.empty()) {
    throw std::invalid_argument("parameter base_frame = " + node.base_frame +
                                " says what odometry describes, but use_tf takes poses from tf: "
                                "set one of the two");
  }
  if (!node.use_tf && node.base_frame.empty() && !node.sensor_frame.empty()) {
    throw std::invalid_argument("parameter sensor_frame = " + node.sensor_frame +
                                " needs base_frame (what odometry describes) or use_tf");
  }
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
  checkFrames(parameters.node);
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

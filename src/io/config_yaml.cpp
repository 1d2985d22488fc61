// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/config_yaml.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <yaml-cpp/yaml.h>

#include "segdf/io/scan_source.hpp"
#include "segdf/io/sensor_files.hpp"

namespace segdf {

namespace {

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// Visitor that takes values out of a YAML document and remembers which keys exist.
class YamlReader {
 public:
  YamlReader(const YAML::Node& root, std::string where) : root_(root), where_(std::move(where)) {}

  template <class T>
  void section(const std::string& name, T& values, const char*) {
    sections_.push_back(name);
    node_.reset(root_[name]);
    if (!node_ || node_.IsNull()) return;
    if (!node_.IsMap()) fail(name + " must hold parameters, 'name: value'");
    prefix_ = name + ".";
    keys_.clear();
    T::visit(values, *this);
    refuseUnknown(node_, keys_, prefix_);
  }

  void number(const char* name, double& value, double, double, const char*, const char*) {
    read(name, value, "a number");
  }
  void integer(const char* name, int& value, int, int, const char*, const char*) {
    read(name, value, "a whole number");
  }
  template <std::size_t N>
  void numbers(
      const char* name, std::array<double, N>& values, double, double, const char*, const char*) {
    const std::string wanted = "a list of " + std::to_string(N) + " numbers";
    const YAML::Node entry = find(name);
    if (!entry) return;
    if (!entry.IsSequence() || entry.size() != N) wrong(name, entry, wanted);
    for (std::size_t k = 0; k < N; ++k) convert(name, entry[k], values[k], wanted);
  }
  template <class Enum, std::size_t N>
  void choice(const char* name,
              Enum& value,
              const std::array<EnumName<Enum>, N>& names,
              const char*) {
    std::string text;
    if (!read(name, text, "a name")) return;
    std::string known;
    for (const EnumName<Enum>& entry : names) {
      known += (known.empty() ? "" : ", ") + std::string(entry.name);
      if (text != entry.name) continue;
      value = entry.value;
      return;
    }
    fail("parameter " + prefix_ + name + " = " + text + " is not one of: " + known);
  }

  /// After all sections: whatever else stands at the top is unknown.
  void finish() const { refuseUnknown(root_, sections_, ""); }

 private:
  YAML::Node find(const char* name) {
    keys_.emplace_back(name);
    return node_[name];
  }

  template <class T>
  bool read(const char* name, T& value, const std::string& wanted) {
    const YAML::Node entry = find(name);
    if (!entry) return false;
    convert(name, entry, value, wanted);
    return true;
  }

  template <class T>
  void convert(const char* name,
               const YAML::Node& entry,
               T& value,
               const std::string& wanted) const {
    try {
      value = entry.as<T>();
    } catch (const YAML::Exception&) {
      wrong(name, entry, wanted);
    }
  }

  [[noreturn]] void wrong(const char* name,
                          const YAML::Node& entry,
                          const std::string& wanted) const {
    const std::string value = entry.IsScalar() ? entry.Scalar() : "(not a single value)";
    fail("parameter " + prefix_ + name + " = " + value + " must be " + wanted);
  }

  void refuseUnknown(const YAML::Node& map,
                     const std::vector<std::string>& known,
                     const std::string& prefix) const {
    for (const auto& entry : map) {
      const auto key = entry.first.as<std::string>();
      std::string list;
      bool found = false;
      for (const std::string& name : known) {
        found = found || name == key;
        list.append(list.empty() ? "" : ", ").append(name);
      }
      if (!found) failUnknown(prefix + key, list);
    }
  }

  [[noreturn]] void failUnknown(const std::string& name, const std::string& known) const {
    fail("unknown parameter " + quoted(name) + "; known are: " + known);
  }

  [[noreturn]] void fail(const std::string& message) const {
    throw IoError(where_ + ": " + message);
  }

  YAML::Node root_;
  std::string where_;
  YAML::Node node_;
  std::string prefix_;
  std::vector<std::string> keys_;
  std::vector<std::string> sections_;
};

/// Visitor that writes every parameter with its comment.
class YamlWriter {
 public:
  template <class T>
  void section(const std::string& name, const T& values, const char* meaning) {
    text_ << (text_.tellp() > 0 ? "\n" : "") << name << ":  # " << meaning << "\n";
    T::visit(values, *this);
  }
  void number(const char* name,
              double value,
              double min,
              double max,
              const char* unit,
              const char* meaning) {
    line(name, formatNumber(value), min, max, unit, meaning);
  }
  void integer(
      const char* name, int value, int min, int max, const char* unit, const char* meaning) {
    line(name, std::to_string(value), min, max, unit, meaning);
  }
  template <std::size_t N>
  void numbers(const char* name,
               const std::array<double, N>& values,
               double min,
               double max,
               const char* unit,
               const char* meaning) {
    std::string list;
    for (double value : values) list += (list.empty() ? "" : ", ") + formatNumber(value);
    line(name, "[" + list + "]", min, max, unit, meaning);
  }
  template <class Enum, std::size_t N>
  void choice(const char* name,
              Enum value,
              const std::array<EnumName<Enum>, N>& names,
              const char* meaning) {
    std::string list;
    for (const EnumName<Enum>& entry : names) {
      list += (list.empty() ? "" : " | ") + std::string(entry.name);
    }
    std::string chosen = nameOf(value, names);
    // Unquoted, the YAML 1.1 of rosparam reads off as a boolean.
    if (chosen == "off") chosen = "\"off\"";
    text_ << "  " << name << ": " << chosen << "  # " << list << "; " << meaning << "\n";
  }

  std::string text() const { return text_.str(); }

 private:
  void line(const char* name,
            const std::string& value,
            double min,
            double max,
            const std::string& unit,
            const char* meaning) {
    text_ << "  " << name << ": " << value << "  # [" << formatNumber(min) << ", "
          << formatNumber(max) << "]" << (unit.empty() ? "" : " " + unit) << "; " << meaning
          << "\n";
  }

  std::ostringstream text_;
};

YAML::Node parse(const std::string& yaml, const std::string& where) {
  try {
    return YAML::Load(yaml);
  } catch (const YAML::Exception& error) {
    throw IoError(where + ": line " + std::to_string(error.mark.line + 1) +
                  " is no YAML: " + error.msg);
  }
}

}  // namespace

void applyYaml(Config& config, const std::string& yaml, const std::string& where) {
  const YAML::Node root = parse(yaml, where);
  if (root.IsNull()) return;
  if (!root.IsMap())
    throw IoError(where + ": must hold sections of parameters, as cfg/segdf.yaml does");
  YamlReader reader(root, where);
  Config::visit(config, reader);
  reader.finish();
  try {
    validate(config);
  } catch (const std::invalid_argument& error) {
    throw IoError(where + ": " + error.what());
  }
}

void applyYamlFile(Config& config, const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw IoError("cannot read configuration " + file.string() + "; check the path");
  applyYaml(config, text.str(), file.string());
}

std::string toYaml(const Config& config) {
  YamlWriter writer;
  Config::visit(config, writer);
  return writer.text();
}

std::vector<std::string> knownSensors() {
  std::vector<std::string> names;
  for (const auto& [name, text] : sensorFiles()) names.push_back(name);
  return names;
}

Config sensorConfig(const std::string& sensor) {
  Config config;
  const auto file = sensorFiles().find(sensor);
  if (file == sensorFiles().end()) {
    std::string known;
    for (const std::string& name : knownSensors()) known += (known.empty() ? "" : ", ") + name;
    throw IoError("unknown sensor " + quoted(sensor) + "; known are: " + known);
  }
  applyYaml(config, file->second, "cfg/sensors/" + sensor + ".yaml");
  return config;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "segdf/core/config.hpp"

namespace segdf {

/// Overwrites the parameters that the YAML text names and leaves the others. Strict: an unknown
/// section or key, a value of the wrong kind and a value out of bounds are errors.
/// @param where names the text in messages, e.g. a file's path
/// @throws IoError naming the parameter, its value, and what is allowed
void applyYaml(Config& config, const std::string& yaml, const std::string& where);

/// As applyYaml for a file. @throws IoError also when it cannot be read
void applyYamlFile(Config& config, const std::filesystem::path& file);

/// All parameters as YAML, with unit, range and meaning behind each: cfg/segdf.yaml is this text
/// for the defaults.
std::string toYaml(const Config& config);

/// Names of the sensors whose overrides (cfg/sensors/NAME.yaml) are built in.
std::vector<std::string> knownSensors();

/// Defaults with the overrides of one sensor. @throws IoError naming the known ones for an unknown
/// name
Config sensorConfig(const std::string& sensor);

}  // namespace segdf

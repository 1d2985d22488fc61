// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "segdf/simulation/scene_description.hpp"

namespace segdf {

/// Reads a scene file's text. Strict: an unknown or missing key, a value of the wrong kind and one
/// out of bounds are errors.
/// @param where names the text in messages, e.g. a file's path
/// @throws std::invalid_argument naming the key, its value and what is allowed, in one line
SceneDescription parseScene(const std::string& yaml, const std::string& where);

/// Names of the built-in scenes (cfg/scenes/NAME.yaml), in order.
std::vector<std::string> sceneNames();

/// First line of a built-in scene's text: what it is about. @throws as loadScene
std::string sceneSummary(const std::string& name);

/// A built-in scene by its name, or a scene file by its path.
/// @throws std::invalid_argument when it is neither, or as parseScene
SceneDescription loadScene(const std::string& name_or_file);

}  // namespace segdf

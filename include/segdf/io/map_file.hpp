// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace segdf {

/// A map that any tool may have written.
struct MapCloud {
  std::vector<Eigen::Vector3f> points;  ///< finite ones, metres
  std::vector<std::uint32_t> labels;    ///< of each point, where a field was asked for
  std::size_t not_finite = 0;           ///< points left out
};

/// Reads a PCD file of any layout (ascii, binary, compressed; x y z as float or double; any other
/// fields, in any order).
/// @param label_field field that holds SemanticKITTI labels, "" for none
/// @throws IoError when it is no PCD file, has no x y z, no such label field, no finite point, or
/// labels that a float could not hold (class and instance packed above 2^24)
MapCloud readMap(const std::filesystem::path& file, const std::string& label_field = "");

/// One point of a map that is written to be looked at.
struct ColouredPoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< metres
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint32_t label = 0;
};

/// Writes a binary PCD with the fields x y z rgb label, beside and renamed. @throws IoError
void writeColouredMap(const std::filesystem::path& file, const std::vector<ColouredPoint>& points);

}  // namespace segdf

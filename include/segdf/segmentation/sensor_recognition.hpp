// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "segdf/core/scan.hpp"

namespace segdf {

/// What the recognition saw, for the line that tells the user which sensor was chosen.
struct SensorGuess {
  std::string name;            ///< "hdl64", "hdl32", "vlp16" or "os1_64": file in cfg/sensors
  int beams = 0;               ///< lasers seen
  double elevation_min = 0.0;  ///< degrees, lowest laser
  double elevation_max = 0.0;  ///< degrees, highest laser
  bool certain = false;        ///< false: nearest known sensor, not a match
};

/// Recognises the sensor from the rings or elevations of one scan.
SensorGuess recogniseSensor(const Scan& scan);

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "segdf/io/kitti_source.hpp"
#include "segdf/simulation/simulator.hpp"

namespace segdf::test {

/// A scan of an HDL-64E to measure with: the first of SemanticKITTI's sequence 05 below SEGDF_DATA
/// when there is one, else a simulated one.
inline Scan benchmarkScan() {
  const char* data = std::getenv("SEGDF_DATA");
  const std::filesystem::path drive =
      std::filesystem::path(data == nullptr ? "" : data) / "semantickitti/sequences/05";
  if (data != nullptr && std::filesystem::is_directory(drive)) {
    std::cerr << "on the first scan of sequence 05\n";
    return KittiSource(drive).next().value();
  }
  std::cerr << "on a simulated scan (SEGDF_DATA names no folder with sequence 05)\n";
  return Simulator(SimulationConfig{}).next().value().scan;
}

}  // namespace segdf::test

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/report/evidence.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

std::size_t columnOf(const Evidence& evidence,
                     const std::string& name,
                     const std::filesystem::path& file) {
  const auto found = std::find(evidence.columns.begin(), evidence.columns.end(), name);
  if (found == evidence.columns.end()) {
    throw IoError(file.string() + " has no column '" + name + "'; did segdf write it?");
  }
  return static_cast<std::size_t>(found - evidence.columns.begin());
}

}  // namespace

Evidence readEvidence(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw IoError("cannot read " + file.string());
  Evidence evidence;
  std::string line;
  std::getline(stream, line);
  evidence.columns = split(line);
  columnOf(evidence, "id", file);
  const std::size_t points = columnOf(evidence, "points", file);
  const std::size_t verdict = columnOf(evidence, "verdict", file);
  while (std::getline(stream, line)) {
    std::vector<std::string> cells = split(line);
    cells.resize(evidence.columns.size());
    if (cells[verdict] == "dynamic") evidence.removed.push_back(std::move(cells));
  }
  std::stable_sort(
      evidence.removed.begin(), evidence.removed.end(), [points](const auto& a, const auto& b) {
        return std::strtod(a[points].c_str(), nullptr) > std::strtod(b[points].c_str(), nullptr);
      });
  return evidence;
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/pose_file.hpp"

#include <fstream>
#include <iomanip>
#include <limits>
#include <optional>
#include <sstream>

#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace {

std::optional<Pose> parsePose(const std::string& text) {
  std::istringstream stream(text);
  Pose pose = Pose::Identity();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) stream >> pose.matrix()(row, column);
  }
  if (!stream) return std::nullopt;
  stream >> std::ws;
  return stream.eof() ? std::optional<Pose>(pose) : std::nullopt;
}

std::ifstream open(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw IoError("cannot read " + file.string() + "; check the path");
  return stream;
}

}  // namespace

std::vector<Pose> readPoses(const std::filesystem::path& file) {
  std::ifstream stream = open(file);
  std::vector<Pose> poses;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::optional<Pose> pose = parsePose(line);
    if (!pose) {
      throw IoError("line " + std::to_string(number) + " of " + file.string() +
                    " is no pose: it must hold 12 numbers (3x4 matrix, row by row)");
    }
    poses.push_back(*pose);
  }
  return poses;
}

Pose readCalibration(const std::filesystem::path& file) {
  std::ifstream stream = open(file);
  std::string line;
  while (std::getline(stream, line)) {
    if (line.rfind("Tr:", 0) != 0 && line.rfind("Tr ", 0) != 0) continue;
    const std::optional<Pose> pose = parsePose(line.substr(3));
    if (pose) return *pose;
  }
  throw IoError(
      "no line 'Tr: <12 numbers>' in " + file.string() +
      "; without it poses.txt cannot be taken to the lidar frame (or give poses_lidar.txt)");
}

std::string formatPose(const Pose& pose) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  for (Eigen::Index k = 0; k < 12; ++k) text << (k > 0 ? " " : "") << pose.matrix()(k / 4, k % 4);
  return text.str();
}

}  // namespace segdf

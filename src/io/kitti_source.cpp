// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/kitti_source.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "segdf/io/pose_file.hpp"
#include "segdf/segmentation/ring_recovery.hpp"

namespace segdf {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPointBytes = 4 * sizeof(float);
constexpr std::size_t kPointsAtOnce = 4096;

std::vector<fs::path> listScans(const fs::path& folder) {
  const fs::path velodyne = folder / "velodyne";
  if (!fs::is_directory(velodyne)) {
    throw IoError("no folder " + velodyne.string() + "; a KITTI folder holds velodyne/NNNNNN.bin");
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(velodyne)) {
    if (entry.path().extension() == ".bin") files.push_back(entry.path());
  }
  if (files.empty()) throw IoError("no .bin file in " + velodyne.string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Pose> readLidarPoses(const fs::path& folder) {
  const fs::path lidar = folder / "poses_lidar.txt";
  const fs::path camera = folder / "poses.txt";
  if (fs::exists(lidar)) return readPoses(lidar);
  if (!fs::exists(camera)) {
    throw IoError("neither poses.txt nor poses_lidar.txt in " + folder.string() +
                  "; every scan needs a pose");
  }
  std::vector<Pose> poses = readPoses(camera);
  const Pose camera_T_lidar = readCalibration(folder / "calib.txt");
  for (Pose& pose : poses) pose = camera_T_lidar.inverse() * pose * camera_T_lidar;
  return poses;
}

void requireCount(const char* what, std::size_t have, std::size_t scans, const fs::path& folder) {
  if (have == scans) return;
  throw IoError(std::to_string(have) + " " + what + " for " + std::to_string(scans) + " scans in " +
                folder.string() + "; there must be one for each scan");
}

std::vector<double> readTimes(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<double> times;
  for (double time = 0.0; stream >> time;) times.push_back(time);
  if (!stream.eof()) {
    throw IoError("entry " + std::to_string(times.size() + 1) + " of " + file.string() +
                  " is no number of seconds");
  }
  return times;
}

std::vector<Point> readPoints(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream) throw IoError("cannot read scan " + file.string());
  const auto bytes = static_cast<std::size_t>(stream.tellg());
  if (bytes % kPointBytes != 0) {
    throw IoError(
        "scan " + file.string() + " has " + std::to_string(bytes) +
        " bytes, no multiple of 16 (float32 x y z intensity): it is truncated or no KITTI scan");
  }
  stream.seekg(0);
  const std::size_t total = bytes / kPointBytes;
  std::vector<Point> points;
  points.reserve(total);
  std::array<std::array<float, 4>, kPointsAtOnce> raw;
  while (points.size() < total) {
    const std::size_t count = std::min(kPointsAtOnce, total - points.size());
    stream.read(reinterpret_cast<char*>(raw.data()),
                static_cast<std::streamsize>(count * kPointBytes));
    if (!stream) throw IoError("cannot read scan " + file.string() + " to its end");
    for (std::size_t k = 0; k < count; ++k) {
      points.push_back({raw[k][0], raw[k][1], raw[k][2], raw[k][3], 0.0F, -1});
    }
  }
  return points;
}

std::vector<std::size_t> select(const FrameRange& frames,
                                std::size_t scans,
                                const fs::path& folder) {
  if (!frames.isAll() && frames.last >= scans) {
    throw IoError("frames up to " + std::to_string(frames.last) + " are asked for, but " +
                  folder.string() + " has " + std::to_string(scans) + " scans (0 to " +
                  std::to_string(scans - 1) + ")");
  }
  std::vector<std::size_t> selected;
  for (std::size_t i = frames.first; i < scans && i <= frames.last; i += frames.step) {
    selected.push_back(i);
  }
  return selected;
}

}  // namespace

KittiSource::KittiSource(const fs::path& folder, double assumed_rate_hz, const FrameRange& frames)
    : folder_(folder),
      files_(listScans(folder)),
      poses_(readLidarPoses(folder)),
      selected_(select(frames, files_.size(), folder)) {
  requireCount("poses", poses_.size(), files_.size(), folder);
  if (fs::exists(folder / "times.txt")) {
    times_ = readTimes(folder / "times.txt");
    requireCount("times", times_.size(), files_.size(), folder);
    return;
  }
  times_assumed_ = true;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    times_.push_back(static_cast<double>(i) / assumed_rate_hz);
  }
}

std::optional<Scan> KittiSource::next() {
  std::optional<Scan> scan = nextWithoutRings();
  if (scan) recoverRings(scan->points);  // an interleaved file stays without rings
  return scan;
}

std::optional<Scan> KittiSource::nextWithoutRings() {
  if (next_ == selected_.size()) return std::nullopt;
  const std::size_t i = selected_[next_++];
  Scan scan;
  scan.points = readPoints(files_[i]);
  scan.pose = poses_[i];
  scan.stamp_ns = std::llround(times_[i] * 1e9);
  return scan;
}

std::string KittiSource::describe() const {
  return "KITTI folder " + folder_.string() + " (" + std::to_string(size()) + " scans)";
}

Pose defaultCalibration() {
  Pose camera_T_lidar = Pose::Identity();
  camera_T_lidar.linear() << 0.0, -1.0, 0.0,  // camera x is lidar -y
      0.0, 0.0, -1.0,                         // camera y is lidar -z
      1.0, 0.0, 0.0;                          // camera z is lidar x
  return camera_T_lidar;
}

}  // namespace segdf

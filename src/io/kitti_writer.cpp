// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/kitti_writer.hpp"

#include <array>

#include "segdf/core/config.hpp"
#include "segdf/io/atomic_file.hpp"
#include "segdf/io/kitti_source.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/pose_file.hpp"
#include "segdf/io/scan_name.hpp"

namespace segdf {

namespace fs = std::filesystem;

namespace {

void writePoints(const fs::path& file, const std::vector<Point>& points) {
  std::vector<std::array<float, 4>> raw;
  raw.reserve(points.size());
  for (const Point& p : points) raw.push_back({p.x, p.y, p.z, p.intensity});
  AtomicFile out(file);
  out.write(raw.data(), raw.size() * sizeof(raw[0]));
  out.commit();
}

/// Camera poses relative to the camera at `origin` (map_T_lidar of the first scan).
std::string cameraPoses(const std::vector<Pose>& poses, const Pose& origin) {
  const Pose camera_T_lidar = defaultCalibration();
  std::string text;
  for (const Pose& pose : poses) {
    text += formatPose(camera_T_lidar * origin.inverse() * pose * camera_T_lidar.inverse()) + "\n";
  }
  return text;
}

}  // namespace

KittiWriter::KittiWriter(const fs::path& folder) : folder_(folder) {
  const fs::path velodyne = folder / "velodyne";
  std::error_code error;
  fs::create_directories(velodyne, error);
  if (error) {
    throw IoError("cannot create " + velodyne.string() + ": " + error.message() +
                  "; choose a folder that can be written");
  }
  if (!fs::is_empty(velodyne)) {
    throw IoError(velodyne.string() + " holds scans already; choose another folder or remove it");
  }
}

void KittiWriter::add(const Scan& scan,
                      const std::vector<std::uint32_t>& truth,
                      const Pose& exact_pose) {
  const std::string name = scanName(poses_.size());
  writePoints(folder_ / "velodyne" / (name + ".bin"), scan.points);
  if (!truth.empty()) {
    fs::create_directories(folder_ / "labels");
    writeLabels(folder_ / "labels" / (name + ".label"), truth);
  }
  poses_.push_back(scan.pose);
  exact_poses_.push_back(exact_pose);
  times_.push_back(scan.stampSeconds());
}

void KittiWriter::finish() {
  if (poses_.empty()) return;
  std::string times;
  for (double time : times_) times += formatNumber(time) + "\n";
  writeWhole(folder_ / "times.txt", times);
  writeWhole(folder_ / "calib.txt", "Tr: " + formatPose(defaultCalibration()) + "\n");
  writeWhole(folder_ / "poses_gt.txt", cameraPoses(exact_poses_, exact_poses_.front()));
  writeWhole(folder_ / "poses.txt", cameraPoses(poses_, poses_.front()));
}

}  // namespace segdf

// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/drive_writer.hpp"

#include <algorithm>
#include <exception>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/atomic_file.hpp"
#include "segdf/io/config_yaml.hpp"
#include "segdf/io/instance_csv.hpp"
#include "segdf/io/label_file.hpp"
#include "segdf/io/scan_name.hpp"
#include "segdf/io/top_down_image.hpp"

namespace segdf {

namespace {

constexpr const char* kStaticMap = "static_map.pcd";
constexpr const char* kDynamicPoints = "dynamic_points.pcd";

std::vector<std::uint32_t> encodeAll(const std::vector<PointLabel>& labels) {
  std::vector<std::uint32_t> codes;
  codes.reserve(labels.size());
  for (const PointLabel& label : labels) codes.push_back(semantic_kitti::encode(label));
  return codes;
}

}  // namespace

DriveWriter::DriveWriter(const std::filesystem::path& folder, const Config& config)
    : config_(config),
      folder_(folder),
      static_points_(folder_.staging() / kStaticMap, config.map.voxel),
      dynamic_points_(folder_.staging() / kDynamicPoints),
      evidence_(folder_.staging() / "evidence.csv") {
  std::filesystem::create_directory(folder_.staging() / "labels");
}

/// The labels of the scans in which it stood are on disk already. What they hold is what counts:
/// between two scans in which it was seen to stand there may be some in which it was not.
void DriveWriter::revoke(const Revocation& revocation) {
  Revocation found = revocation;
  found.points = 0;
  for (std::size_t scan = revocation.first; scan <= revocation.last; ++scan) {
    const std::filesystem::path file = labelsOf(scan);
    std::vector<std::uint32_t> labels = readLabels(file);
    const std::size_t points = semantic_kitti::revoke(labels, revocation.id);
    if (points > 0) writeLabels(file, labels);
    found.points += points;
  }
  report_.revoke(found);
  instances_.revoke(found);
  static_points_.revoke(found);
}

std::filesystem::path DriveWriter::labelsOf(std::size_t scan) const {
  return folder_.staging() / "labels" / (scanName(scan) + ".label");
}

void DriveWriter::add(const FrameResult& frame) {
  for (const Revocation& revocation : frame.revoked) revoke(revocation);
  report_.add(frame);
  instances_.add(frame);
  evidence_.add(frame);
  writeLabels(labelsOf(frame.index), encodeAll(frame.labels));
  dynamic_points_.add(
      mapPointsWhere(frame, [](PointState state) { return state == PointState::kDynamic; }));
  static_points_.add(frame);
  if (frame.status == FrameStatus::kMapped) {
    trajectory_.emplace_back(frame.scan.pose.translation().head<2>());
  }
}

void DriveWriter::writeInstances() {
  const std::vector<InstanceRecord> records = instances_.records();
  writeInstanceCsv(folder_.staging() / "instances.csv", records);
  const auto removed = std::count_if(records.begin(), records.end(),
                                     [](const InstanceRecord& r) { return r.isDynamic(); });
  report_.setInstances(records.size(), static_cast<std::size_t>(removed));
}

void DriveWriter::drawMap() const {
  TopDownImage image(trajectory_);
  for (const char* name : {kStaticMap, kDynamicPoints}) {
    forEachPoint(folder_.staging() / name, [&image](const MapPoint& point) { image.add(point); });
  }
  image.write(folder_.staging() / "map.png");
}

void DriveWriter::abandon(const IoError& reason) {
  salvage();
  throw IoError(std::string(reason.what()) + " (what was computed is in " +
                folder_.staging().string() + ")");
}

void DriveWriter::salvage() noexcept {
  const auto attempt = [](const auto& finish) {
    try {
      finish();
    } catch (const std::exception&) {  // the failure that led here has been told already
    }
  };
  attempt([this] { static_points_.salvage(); });
  attempt([this] { dynamic_points_.finish(); });
  attempt([this] { evidence_.finish(); });
}

void DriveWriter::finish() {
  static_points_.finish(dynamic_points_);
  dynamic_points_.finish();
  writeInstances();
  evidence_.finish();
  writeWhole(folder_.staging() / "config.yaml", toYaml(config_));
  drawMap();
  report_.write(folder_.staging() / "report.json");
  folder_.commit();
}

}  // namespace segdf

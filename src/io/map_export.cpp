// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/map_export.hpp"

#include <string>

#include "segdf/io/atomic_file.hpp"
#include "segdf/io/instance_csv.hpp"
#include "segdf/io/pcd_stream.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace fs = std::filesystem;

namespace {

static_assert(sizeof(MapPoint) == 24, "a point is written as its six fields");

void writePcd(const fs::path& file, const std::vector<MapPoint>& points) {
  PcdStream out(file);
  out.add(points);
  out.finish();
}

void writePly(const fs::path& file, const std::vector<MapPoint>& points) {
  AtomicFile out(file);
  out.write("ply\nformat binary_little_endian 1.0\nelement vertex " +
            std::to_string(points.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\nproperty float intensity\n"
            "property uint label\nproperty uint instance\nend_header\n");
  out.write(points.data(), points.size() * sizeof(MapPoint));
  out.commit();
}

void refuseExisting(const fs::path& file) {
  if (!fs::exists(file)) return;
  throw IoError(file.string() + " exists and is left alone; choose another name");
}

}  // namespace

fs::path instanceFileOf(const fs::path& map) {
  return map.parent_path() / (map.stem().string() + "_instances.csv");
}

void checkExport(const fs::path& map) {
  if (!map.is_absolute()) {
    throw IoError("'" + map.string() + "' is no absolute path; start it with /");
  }
  if (map.extension() != ".pcd" && map.extension() != ".ply") {
    throw IoError("'" + map.string() + "' ends neither in .pcd nor in .ply");
  }
  refuseExisting(map);
  refuseExisting(instanceFileOf(map));
}

void exportMap(const fs::path& map,
               const std::vector<MapPoint>& points,
               const std::vector<InstanceRecord>& instances) {
  checkExport(map);
  writeInstanceCsv(instanceFileOf(map), instances);
  if (map.extension() == ".ply") {
    writePly(map, points);
  } else {
    writePcd(map, points);
  }
}

}  // namespace segdf

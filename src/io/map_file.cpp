// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/io/map_file.hpp"

#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <set>

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "segdf/io/atomic_file.hpp"
#include "segdf/io/scan_source.hpp"

namespace segdf {

namespace {

using pcl::PCLPointField;

// Above it a float does not hold every whole number.
constexpr double kExactFloat = 16777216.0;

/// PCL's reader crashes on files that do not begin as a PCD file does.
bool hasHeader(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::set<std::string> seen;
  constexpr int kMostLines = 100;  // a header has eleven, and comments
  std::string line;
  for (int k = 0; k < kMostLines && std::getline(stream, line); ++k) {
    const std::string word = line.substr(0, line.find(' '));
    if (word == "DATA") return seen.count("FIELDS") * seen.count("SIZE") * seen.count("TYPE") == 1;
    seen.insert(word);
  }
  return false;
}

pcl::PCLPointCloud2 readCloud(const std::filesystem::path& file) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // our one line, not several of PCL's
  if (!std::filesystem::is_regular_file(file)) {
    throw IoError("no map " + file.string() + "; check the path");
  }
  const IoError unreadable("map " + file.string() + " is truncated or no PCD file");
  if (!hasHeader(file)) throw unreadable;
  pcl::PCLPointCloud2 cloud;
  try {
    if (pcl::PCDReader().read(file.string(), cloud) < 0) throw unreadable;
  } catch (const std::exception&) {  // PCL's text names its own function, not what is wrong
    throw unreadable;
  }
  return cloud;
}

const PCLPointField* findField(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  for (const PCLPointField& field : cloud.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::string fieldNames(const pcl::PCLPointCloud2& cloud) {
  std::string names;
  for (const PCLPointField& field : cloud.fields) {
    if (field.name != "_") names += (names.empty() ? "" : " ") + field.name;
  }
  return names;
}

const PCLPointField& requireField(const pcl::PCLPointCloud2& cloud,
                                  const std::string& name,
                                  const std::filesystem::path& file) {
  const PCLPointField* field = findField(cloud, name);
  if (field != nullptr) return *field;
  throw IoError("map " + file.string() + " has no field '" + name +
                "'; it has: " + fieldNames(cloud));
}

template <class T>
double valueAt(const std::uint8_t* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

double read(const PCLPointField& field, const std::uint8_t* point) {
  const std::uint8_t* bytes = point + field.offset;
  switch (field.datatype) {
    case PCLPointField::INT8:
      return valueAt<std::int8_t>(bytes);
    case PCLPointField::UINT8:
      return valueAt<std::uint8_t>(bytes);
    case PCLPointField::INT16:
      return valueAt<std::int16_t>(bytes);
    case PCLPointField::UINT16:
      return valueAt<std::uint16_t>(bytes);
    case PCLPointField::INT32:
      return valueAt<std::int32_t>(bytes);
    case PCLPointField::UINT32:
      return valueAt<std::uint32_t>(bytes);
    case PCLPointField::FLOAT64:
      return valueAt<double>(bytes);
    default:
      return valueAt<float>(bytes);
  }
}

std::uint32_t toLabel(double value, const PCLPointField& field, const std::filesystem::path& file) {
  const bool whole = value >= 0.0 && value <= 4294967295.0 && value == std::floor(value);
  const bool exact = field.datatype != PCLPointField::FLOAT32 || value <= kExactFloat;
  if (whole && exact) return static_cast<std::uint32_t>(value);
  throw IoError("field '" + field.name + "' of map " + file.string() +
                " holds a value that is no label" +
                (whole ? ": a float32 cannot hold class and instance of it" : "") +
                "; leave --map-labels away and labels are taken from the truth");
}

}  // namespace

MapCloud readMap(const std::filesystem::path& file, const std::string& label_field) {
  const pcl::PCLPointCloud2 cloud = readCloud(file);
  const PCLPointField& x = requireField(cloud, "x", file);
  const PCLPointField& y = requireField(cloud, "y", file);
  const PCLPointField& z = requireField(cloud, "z", file);
  const PCLPointField* label =
      label_field.empty() ? nullptr : &requireField(cloud, label_field, file);
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  MapCloud map;
  map.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
    const Eigen::Vector3d place(read(x, point), read(y, point), read(z, point));
    if (!place.allFinite()) {
      ++map.not_finite;
      continue;
    }
    map.points.emplace_back(place.cast<float>());
    if (label != nullptr) map.labels.push_back(toLabel(read(*label, point), *label, file));
  }
  if (map.points.empty()) throw IoError("map " + file.string() + " holds no point");
  return map;
}

void writeColouredMap(const std::filesystem::path& file, const std::vector<ColouredPoint>& points) {
  pcl::PointCloud<pcl::PointXYZRGBL> cloud;
  cloud.reserve(points.size());
  for (const ColouredPoint& p : points) {
    pcl::PointXYZRGBL point;
    point.getVector3fMap() = p.position;
    point.r = p.red;
    point.g = p.green;
    point.b = p.blue;
    point.label = p.label;
    cloud.push_back(point);
  }
  AtomicFile out(file);
  try {
    pcl::PCDWriter().writeBinary(out.temporaryPath().string(), cloud);
  } catch (const std::exception& error) {
    throw IoError("cannot write " + file.string() + ": " + error.what());
  }
  out.commit();
}

}  // namespace segdf

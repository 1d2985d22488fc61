// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/cloud_fields.hpp"

#include <array>
#include <cstring>
#include <stdexcept>

#include "segdf/io/scan_source.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointField;
using Decode = double (*)(const std::uint8_t*);

template <class Number>
double decode(const std::uint8_t* bytes) {
  Number value;
  std::memcpy(&value, bytes, sizeof(value));
  return static_cast<double>(value);
}

struct Datatype {
  const char* name;
  std::size_t size;
  Decode decode;
};

template <class Number>
constexpr Datatype datatype(const char* name) {
  return {name, sizeof(Number), decode<Number>};
}

const Datatype* find(std::uint8_t code) {
  static constexpr std::array<Datatype, 8> kDatatypes{
      datatype<std::int8_t>("int8"),   datatype<std::uint8_t>("uint8"),
      datatype<std::int16_t>("int16"), datatype<std::uint16_t>("uint16"),
      datatype<std::int32_t>("int32"), datatype<std::uint32_t>("uint32"),
      datatype<float>("float32"),      datatype<double>("float64")};
  static_assert(PointField::INT8 == 1 && PointField::FLOAT64 == kDatatypes.size());
  return code >= 1 && code <= kDatatypes.size() ? &kDatatypes[code - 1] : nullptr;
}

[[noreturn]] void refuse(const std::string& topic, const std::string& reason) {
  throw IoError("cloud on topic '" + topic + "' is broken: " + reason +
                "; correct the node that publishes it");
}

void checkField(const sensor_msgs::PointCloud2& cloud,
                const PointField& field,
                const std::string& topic) {
  const std::size_t size = datatypeSize(field.datatype);
  if (size == 0) refuse(topic, "field '" + field.name + "' has " + datatypeName(field.datatype));
  if (field.offset + size > cloud.point_step) {
    refuse(topic, "field '" + field.name + "' ends at byte " + std::to_string(field.offset + size) +
                      " of points of " + std::to_string(cloud.point_step) + " bytes");
  }
}

}  // namespace

std::size_t datatypeSize(std::uint8_t datatype) {
  const Datatype* found = find(datatype);
  return found == nullptr ? 0 : found->size;
}

std::string datatypeName(std::uint8_t datatype) {
  const Datatype* found = find(datatype);
  return found == nullptr ? "datatype " + std::to_string(datatype) : found->name;
}

void addField(sensor_msgs::PointCloud2& cloud, const std::string& name, std::uint8_t datatype) {
  PointField field;
  field.name = name;
  const auto size = static_cast<std::uint32_t>(datatypeSize(datatype));
  if (size == 0) throw std::invalid_argument("field '" + name + "' has " + datatypeName(datatype));
  field.offset = (cloud.point_step + size - 1) / size * size;
  field.datatype = datatype;
  field.count = 1;
  cloud.fields.push_back(field);
  cloud.point_step = field.offset + size;
}

const PointField* findField(const sensor_msgs::PointCloud2& cloud, const std::string& name) {
  for (const PointField& field : cloud.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

std::string fieldNames(const sensor_msgs::PointCloud2& cloud) {
  std::string names;
  for (const PointField& field : cloud.fields) names += (names.empty() ? "" : " ") + field.name;
  return names.empty() ? "none" : names;
}

void checkLayout(const sensor_msgs::PointCloud2& cloud, const std::string& topic) {
  if (cloud.is_bigendian != 0) refuse(topic, "its numbers are big-endian");
  for (const PointField& field : cloud.fields) checkField(cloud, field, topic);
  const std::size_t row = std::size_t{cloud.width} * cloud.point_step;
  if (cloud.row_step < row) {
    refuse(topic, "row_step " + std::to_string(cloud.row_step) +
                      " is less than width x point_step = " + std::to_string(row) + " bytes");
  }
  const std::size_t all = std::size_t{cloud.row_step} * cloud.height;
  if (cloud.data.size() != all) {
    refuse(topic, "it has " + std::to_string(cloud.data.size()) +
                      " bytes of data, row_step x height = " + std::to_string(all));
  }
}

FieldReader::FieldReader(const PointField& field)
    : offset_(field.offset), decode_(find(field.datatype)->decode) {}

}  // namespace segdf

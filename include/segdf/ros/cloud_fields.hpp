// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <sensor_msgs/PointCloud2.h>

/// The columns of a PointCloud2, checked and read whatever their number type.
namespace segdf {

/// Bytes of one sensor_msgs::PointField datatype; 0 for one that is not defined.
std::size_t datatypeSize(std::uint8_t datatype);

/// "float32", "uint16", ...; "datatype 42" for one that is not defined.
std::string datatypeName(std::uint8_t datatype);

/// Appends a field of one number to each (yet to come) point, where a number of its type may lie:
/// PointCloud2Iterator writes through a pointer to it.
/// @throws std::invalid_argument for a datatype that is not defined
void addField(sensor_msgs::PointCloud2& cloud, const std::string& name, std::uint8_t datatype);

/// The field of that name, or nullptr.
const sensor_msgs::PointField* findField(const sensor_msgs::PointCloud2& cloud,
                                         const std::string& name);

/// "x y z i", for messages.
std::string fieldNames(const sensor_msgs::PointCloud2& cloud);

/// @throws IoError if the numbers are big-endian, or the sizes do not fit each other
/// @param topic names the cloud in the message
void checkLayout(const sensor_msgs::PointCloud2& cloud, const std::string& topic);

/// Reads one field of any number type as double.
class FieldReader {
 public:
  /// @param field with a defined datatype
  explicit FieldReader(const sensor_msgs::PointField& field);

  /// @param point first byte of a point that holds the whole field
  double operator()(const std::uint8_t* point) const { return decode_(point + offset_); }

 private:
  using Decode = double (*)(const std::uint8_t*);

  std::size_t offset_;
  Decode decode_;
};

/// Calls `visit(index, first byte)` for every point, row by row. @pre checkLayout() accepts the
/// cloud
template <class Visit>
void forEachPoint(const sensor_msgs::PointCloud2& cloud, const Visit& visit) {
  std::size_t index = 0;
  for (std::size_t row = 0; row < cloud.height; ++row) {
    const std::uint8_t* point = cloud.data.data() + row * cloud.row_step;
    for (std::size_t column = 0; column < cloud.width; ++column) {
      visit(index++, point);
      point += cloud.point_step;
    }
  }
}

}  // namespace segdf

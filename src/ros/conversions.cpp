// SPDX-License-Identifier: BSD-3-Clause
#include "segdf/ros/conversions.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include <Eigen/Geometry>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/scan_source.hpp"
#include "segdf/ros/cloud_fields.hpp"
#include "segdf/ros/colours.hpp"
#include "segdf/segmentation/ring_recovery.hpp"

namespace segdf {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr double kQuaternionTolerance = 1e-3;  // as isValidPose() has it for rotations

const PointField& needField(const PointCloud2& cloud,
                            const std::string& name,
                            const std::string& topic) {
  const PointField* field = findField(cloud, name);
  if (field != nullptr) return *field;
  throw IoError("cloud on topic '" + topic + "' has no field '" + name + "' (fields: " +
                fieldNames(cloud) + "); segdf needs x y z intensity: publish or rename it");
}

FieldReader coordinate(const PointCloud2& cloud,
                       const std::string& name,
                       const std::string& topic) {
  const PointField& field = needField(cloud, name, topic);
  if (field.datatype == PointField::FLOAT32) return FieldReader(field);
  throw IoError("cloud on topic '" + topic + "' has field '" + name + "' as " +
                datatypeName(field.datatype) + "; segdf needs float32: convert it");
}

void readPositions(const PointCloud2& cloud, const std::string& topic, Scan& scan) {
  const FieldReader x = coordinate(cloud, "x", topic);
  const FieldReader y = coordinate(cloud, "y", topic);
  const FieldReader z = coordinate(cloud, "z", topic);
  const FieldReader intensity(needField(cloud, "intensity", topic));
  forEachPoint(cloud, [&](std::size_t i, const std::uint8_t* bytes) {
    Point& point = scan.points[i];
    point.x = static_cast<float>(x(bytes));
    point.y = static_cast<float>(y(bytes));
    point.z = static_cast<float>(z(bytes));
    point.intensity = static_cast<float>(intensity(bytes));
  });
}

void readRings(const PointCloud2& cloud, const PointField& field, Scan& scan) {
  const FieldReader ring(field);
  forEachPoint(cloud, [&](std::size_t i, const std::uint8_t* bytes) {
    const double value = ring(bytes);
    const bool known = value >= 0.0 && value <= std::numeric_limits<std::int16_t>::max();
    scan.points[i].ring = known ? static_cast<std::int16_t>(value) : std::int16_t{-1};
  });
}

const PointField* timeField(const PointCloud2& cloud) {
  for (const char* name : {"time", "t", "timestamp"}) {
    if (const PointField* field = findField(cloud, name)) return field;
  }
  return nullptr;
}

void readTimes(const PointCloud2& cloud, const PointField& field, Scan& scan) {
  const bool nanoseconds = field.datatype == PointField::UINT32;
  if (!nanoseconds && field.datatype != PointField::FLOAT32 &&
      field.datatype != PointField::FLOAT64) {
    return;  // no convention known; times are optional
  }
  const bool absolute = field.name == "timestamp" && field.datatype == PointField::FLOAT64;
  const double start = absolute ? scan.stampSeconds() : 0.0;
  const double unit = nanoseconds ? 1e-9 : 1.0;
  const FieldReader time(field);
  forEachPoint(cloud, [&](std::size_t i, const std::uint8_t* bytes) {
    scan.points[i].time = static_cast<float>(time(bytes) * unit - start);
  });
}

void bringBackToSensor(Scan& scan) {
  const Pose sensor_T_map = scan.pose.inverse();
  for (Point& point : scan.points) {
    const Eigen::Vector3f position = (sensor_T_map * point.position().cast<double>()).cast<float>();
    point.x = position.x();
    point.y = position.y();
    point.z = position.z();
  }
}

bool isPublished(PointState state, CloudKind kind) {
  switch (kind) {
    case CloudKind::kStatic:
      return isKept(state);
    case CloudKind::kDynamic:
      return state == PointState::kDynamic;
    case CloudKind::kLabelled:
      return true;
  }
  return false;
}

/// One published point, as the fields of outputLayout() lie in memory.
struct PackedPoint {
  float x, y, z, intensity;
  std::uint32_t rgb, label, instance;
};

PointCloud2 outputLayout() {
  PointCloud2 cloud;
  for (const char* name : {"x", "y", "z", "intensity", "rgb"}) {
    addField(cloud, name, PointField::FLOAT32);
  }
  for (const char* name : {"label", "instance"}) addField(cloud, name, PointField::UINT32);
  return cloud;
}

}  // namespace

Pose toPose(const geometry_msgs::Pose& message) {
  const Eigen::Quaterniond rotation(message.orientation.w, message.orientation.x,
                                    message.orientation.y, message.orientation.z);
  Pose pose = Pose::Identity();
  pose.translation() << message.position.x, message.position.y, message.position.z;
  if (std::abs(rotation.norm() - 1.0) < kQuaternionTolerance) {
    pose.linear() = rotation.normalized().toRotationMatrix();
  } else {
    pose.linear().setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  return pose;
}

Scan toScan(const PointCloud2& cloud,
            const nav_msgs::Odometry& odometry,
            const std::string& topic) {
  checkLayout(cloud, topic);
  Scan scan;
  scan.stamp_ns = static_cast<std::int64_t>(cloud.header.stamp.toNSec());
  scan.pose = toPose(odometry.pose.pose);
  scan.points.resize(std::size_t{cloud.width} * cloud.height);
  readPositions(cloud, topic, scan);
  if (const PointField* field = timeField(cloud)) readTimes(cloud, *field, scan);
  if (cloud.header.frame_id == odometry.header.frame_id) bringBackToSensor(scan);
  if (const PointField* field = findField(cloud, "ring")) {
    readRings(cloud, *field, scan);
  } else {
    recoverRings(scan.points);
  }
  return scan;
}

PointCloud2 toCloud(const std::vector<MapPoint>& points, const std_msgs::Header& header) {
  PointCloud2 cloud = outputLayout();
  static_assert(sizeof(PackedPoint) == 28, "fields lie without gaps");
  cloud.header = header;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = 0;  // points that are not judged may be NaN
  cloud.data.resize(cloud.row_step);
  std::uint8_t* out = cloud.data.data();
  for (const MapPoint& p : points) {
    const std::uint32_t rgb = pack(colourOf(p.label, p.instance));
    const PackedPoint packed{p.x, p.y, p.z, p.intensity, rgb, p.label, p.instance};
    std::memcpy(out, &packed, sizeof(packed));
    out += sizeof(packed);
  }
  return cloud;
}

PointCloud2 toCloud(const FrameResult& frame, const std::string& frame_id, CloudKind kind) {
  std::vector<MapPoint> points;
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (!isPublished(frame.labels[i].state, kind)) continue;
    points.push_back(toMapPoint(frame.scan.points[i], frame.scan.pose, frame.labels[i]));
  }
  return toCloud(points, toHeader(frame.scan, frame_id));
}

std_msgs::Header toHeader(const Scan& scan, const std::string& frame_id) {
  std_msgs::Header header;
  header.stamp.fromNSec(static_cast<std::uint64_t>(scan.stamp_ns));
  header.frame_id = frame_id;
  return header;
}

}  // namespace segdf

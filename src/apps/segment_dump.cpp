// SPDX-License-Identifier: BSD-3-Clause
#include "segment_dump.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "segdf/core/semantic_kitti.hpp"
#include "segdf/io/pcd_stream.hpp"
#include "segdf/io/png_file.hpp"
#include "segdf/io/scan_name.hpp"
#include "segdf/mapping/map_point.hpp"
#include "segdf/ros/colours.hpp"

namespace segdf::apps {

namespace {

constexpr std::size_t kSide = 1000;  // pixels
constexpr double kMetresPerPixel = 0.1;
constexpr std::uint8_t kBackground = 20;
constexpr const char* kInstances = "instances";
constexpr const char* kClasses = "classes";

constexpr Colour kNoise{180, 180, 180};
constexpr Colour kVegetation{60, 170, 60};
constexpr Colour kBuilding{225, 190, 110};
constexpr Colour kHighMobility{50, 140, 255};
constexpr Colour kUnknown{210, 90, 220};

bool isInSegment(const PointLabel& label) {
  return label.state == PointState::kStatic || label.state == PointState::kDynamic;
}

Colour instanceColour(const PointLabel& label) {
  if (isInSegment(label)) return colourOf(semantic_kitti::kStatic, label.instance);
  return colourOf(semantic_kitti::classOf(semantic_kitti::encode(label)), 0);
}

Colour classColour(const PointLabel& label) {
  if (!isInSegment(label)) return instanceColour(label);
  switch (label.object_class) {
    case ObjectClass::kVegetation:
      return kVegetation;
    case ObjectClass::kBuilding:
      return kBuilding;
    case ObjectClass::kHighMobility:
      return kHighMobility;
    case ObjectClass::kUnknown:
      return kUnknown;
    case ObjectClass::kNone:
      break;
  }
  return kNoise;
}

using Colouring = std::function<Colour(const PointLabel&)>;

std::vector<ColouredMapPoint> colour(const FrameResult& frame, const Colouring& colouring) {
  std::vector<ColouredMapPoint> points;
  for (std::size_t i = 0; i < frame.labels.size(); ++i) {
    if (frame.labels[i].state == PointState::kUnjudged) continue;
    points.push_back({toMapPoint(frame.scan.points[i], frame.scan.pose, frame.labels[i]),
                      pack(colouring(frame.labels[i]))});
  }
  return points;
}

/// From below to above, the ground first: what is drawn later covers what was drawn before.
void sortForDrawing(std::vector<ColouredMapPoint>& points) {
  const auto is_object = [](const ColouredMapPoint& p) {
    return p.point.label != semantic_kitti::kRoad;
  };
  std::stable_sort(points.begin(), points.end(),
                   [&](const ColouredMapPoint& a, const ColouredMapPoint& b) {
                     if (is_object(a) != is_object(b)) return is_object(b);
                     return a.point.z < b.point.z;
                   });
}

RgbImage draw(std::vector<ColouredMapPoint> points, const Eigen::Vector3d& sensor) {
  RgbImage image{kSide, kSide, std::vector<std::uint8_t>(3 * kSide * kSide, kBackground)};
  sortForDrawing(points);
  for (const ColouredMapPoint& p : points) {
    const double x = (static_cast<double>(p.point.x) - sensor.x()) / kMetresPerPixel + kSide / 2.0;
    const double y = (sensor.y() - static_cast<double>(p.point.y)) / kMetresPerPixel + kSide / 2.0;
    if (!(x >= 0.0 && y >= 0.0 && x < kSide && y < kSide)) continue;
    const std::size_t pixel =
        3 * (static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x));
    for (std::size_t channel = 0; channel < 3; ++channel) {
      image.rgb[pixel + channel] = static_cast<std::uint8_t>(p.rgb >> (16U - 8U * channel));
    }
  }
  return image;
}

void write(const std::filesystem::path& stem,
           const FrameResult& frame,
           const Colouring& colouring) {
  const std::vector<ColouredMapPoint> points = colour(frame, colouring);
  writeColouredPcd(stem.string() + ".pcd", points);
  writePng(stem.string() + ".png", draw(points, frame.scan.pose.translation()));
}

}  // namespace

SegmentDump::SegmentDump(const std::filesystem::path& folder) : folder_(folder) {
  std::filesystem::create_directory(folder_.staging() / kInstances);
  std::filesystem::create_directory(folder_.staging() / kClasses);
}

void SegmentDump::add(const FrameResult& frame) {
  if (frame.status != FrameStatus::kMapped) return;
  const std::string name = scanName(frame.index);
  write(folder_.staging() / kInstances / name, frame, instanceColour);
  write(folder_.staging() / kClasses / name, frame, classColour);
}

}  // namespace segdf::apps
